// SPDX-License-Identifier: BSD-3-Clause
// Elements with frequency-dependent stiffness, evaluated by several threads at once.
#include "trivet/foundation/index.h"
#include "trivet/judging/read_project.h"
#include "trivet/response/steady/steady_motion.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "support/projects.h"

namespace steady_solution_test {

using namespace trivet;

class LawsOnThreads : public testing::TestWithParam<const char*> {};

TEST_P(LawsOnThreads, SixteenGiveTheBytesOfOne) {
  const auto project = judging::read_project(std::string(TRIVET_SOURCE_DIR) + "/tests/samples/" + GetParam(),
                                             {"excitations.push.type=\"harmonic\"", "excitations.push.on=\"frame\"",
                                              "excitations.push.at=[0.1,0,0.2]", "excitations.push.force=[1,2,5]"});
  ASSERT_TRUE(project);
  const model::System& system = project->base().system;
  const assembly::Assembled assembled = assembly::assemble(system);
  ASSERT_TRUE(assembled.frequency_dependent());
  const assembly::Loading loading = assembly::harmonic_loading(system, assembled);
  std::vector<double> omega(25000);
  for (std::size_t i = 0; i < omega.size(); ++i) omega[i] = 13 + 0.024 * static_cast<double>(i);
  numerics::SweepOptions one, sixteen;
  one.threads = 1;
  sixteen.threads = 16;
  const numerics::SweepResult alone = response::steady_solution(assembled, loading, omega, one);
  const numerics::SweepResult together = response::steady_solution(assembled, loading, omega, sixteen);
  ASSERT_TRUE(alone.response.allFinite());
  ASSERT_EQ(alone.response.size(), together.response.size());
  EXPECT_EQ(std::memcmp(alone.response.data(), together.response.data(),
                        to_size(alone.response.size()) * sizeof(std::complex<double>)),
            0);
}

INSTANTIATE_TEST_SUITE_P(Samples, LawsOnThreads, testing::Values("coil_spring.toml", "air_spring.toml"));

}  // namespace steady_solution_test
