// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "support/projects.h"
#include "support/transient.h"
#include "trivet/excitation/pulses_and_sweeps.h"
#include "trivet/foundation/invalid_input.h"

namespace transient_memory_test {

using namespace trivet;

TEST(Transient, RejectsMorePointsTimesChannelsThanMemoryAllows) {
  const auto project = test::project(
      test::chain(std::vector<double>(30, 2.0), std::vector<double>(31, 800.0), std::vector<double>(31, 1.0)));
  const model::System& system = project.base().system;
  const assembly::Assembled assembled = assembly::assemble(system);
  const response::TimeInput push =
      test::force_on(assembled, 0, excitation::half_sine(1, 0.1, 0), spatial::Vector6::Unit(0));
  response::TransientOptions options;
  options.to = 100;
  options.step = 1e-5;  // 10 million points alone are allowed
  try {
    static_cast<void>(test::transient(system, assembled, {"coordinates"}, {push}, options));
    FAIL() << "10,000,001 points of 30 channels are 2.5 GB";
  } catch (const foundation::NotComputable& refusal) {
    EXPECT_THAT(refusal.what(), testing::HasSubstr("10000001 points × 30 results and the time need 2.48 GB"));
  }
}

}  // namespace transient_memory_test
