// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/map/design_sweep.h"

#include <gmock/gmock.h>

#include <cmath>

#include "support/projects.h"

namespace trivet {
namespace design_sweep_test {

const std::string machine = test::driven_pair() + R"(
[analyses]
peaks = {of = ["m1.x"]}
)";

std::vector<double> from_to(double from, double to, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(from + (to - from) * i / (count - 1));
  return values;
}

// One of 40 stiffnesses is negative, in the lowest 0.1 % of their range: it has no model, though its matrices can be
// interpolated.
TEST(DesignSweep, HasNoResultsOfDesignsWithoutAModel) {
  const project::Project project = test::project(machine);
  study::SweepRequest request;
  request.numbers = {{"elements.k1.translation.x", from_to(-100, 77900, 40)}, {"bodies.m1.mass", from_to(8, 12, 5)}};
  const study::DesignSweep found = study::design_sweep(project.base(), request);
  EXPECT_EQ(found.no_kernels, "");
  EXPECT_EQ(found.without_model, 5);
  EXPECT_THAT(found.first_failure, testing::HasSubstr("k1"));
  EXPECT_GE(found.in_kernels, 190);
  for (Eigen::Index i = 0; i < 200; ++i) EXPECT_EQ(std::isnan(found.highest(i, 0)), i < 5) << i;
}

// With the mass of the file below all that are swept, and designs on both sides without a model.
TEST(DesignSweep, FindsTheRangeThatHasModels) {
  const project::Project project = test::project(machine);
  study::SweepRequest request;
  request.numbers = {{"bodies.m1.mass", {12, -3, 20, 0, 15, -1, 30}}};
  const study::DesignSweep found = study::design_sweep(project.base(), request);
  EXPECT_EQ(found.without_model, 3);
  for (const Eigen::Index i : {1, 3, 5}) EXPECT_TRUE(std::isnan(found.highest(i, 0)));
  EXPECT_EQ(found.in_kernels + found.one_by_one, 4);
}

}  // namespace design_sweep_test
}  // namespace trivet
