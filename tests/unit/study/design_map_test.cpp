// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "support/mapped_machine.h"
#include "support/projects.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/study/map/design_map.h"

namespace design_map_test {

using namespace trivet;
using test::mapped_machine;
using test::two_axes;

TEST(DesignMap, GivesEveryDesignItsGoverningRuleAndMargin) {
  const project::Project project = test::project(
      mapped_machine("map = {" + two_axes + ", limits = {\"machine.z\" = \"15 mm\"}, no_peak = \"coordinates\"}\n"));
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
  ASSERT_EQ(map.outcomes.size(), 20u);
  EXPECT_EQ(map.unknown, 0u);
  std::size_t shares = 0;
  for (const study::RuleShare& share : map.shares) shares += share.feasible + share.infeasible;
  EXPECT_EQ(shares, 20u);
  ASSERT_TRUE(map.best);
  for (const design::DesignOutcome& outcome : map.outcomes) EXPECT_LE(outcome.margin, map.outcomes[*map.best].margin);
}

TEST(DesignMap, AcceptsParametersOfTwoElements) {
  const std::string second =
      "[elements.pad]\ntype = \"bushing\"\non = \"machine\"\nat = [0, 0, 0]\ntranslation = [500, 500, 500]\n";
  const project::Project project =
      test::project(mapped_machine("map = {x = {parameter = \"elements.spring.scale\", from = 0.5, to = 2, points = "
                                   "3}, y = {parameter = \"elements.pad.scale\", from = 1, to = 2, "
                                   "points = 3}, limits = {\"machine.z\" = \"15 mm\"}}\n",
                                   second));
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
  EXPECT_EQ(map.unknown, 0u);
  EXPECT_EQ(map.outcomes.size(), 9u);
}

TEST(DesignMap, RejectsAParameterThatMakesEveryDesignImpossible) {
  const project::Project project =
      test::project(mapped_machine("map = {x = {parameter = \"bodies.machine.mass\", from = -5, to = -1, points = 3}, "
                                   "y = {parameter = \"elements.spring.scale\", from = 1, to = 2, "
                                   "points = 2}, no_peak = \"coordinates\"}\n"));
  EXPECT_THAT([&] { static_cast<void>(study::design_map(project, project.base(), *project.base().analyses.map)); },
              testing::ThrowsMessage<foundation::NotComputable>(testing::HasSubstr("none of the 6 designs")));
}

TEST(DesignMap, IsSeparateForACaseThatChangesTheAnalysis) {
  const project::Project project =
      test::project(mapped_machine("map = {" + two_axes + ", no_peak = \"coordinates\"}\n", R"(
[cases.point]
elements.spring.scale = 1.5
[cases.heavy]
bodies.machine.mass = 20
[cases.strict]
analyses.map.peak_tolerance = 0
)"));
  EXPECT_TRUE(study::has_own_map(project, project.base()));
  EXPECT_FALSE(study::has_own_map(project, *project.find("point")));
  EXPECT_FALSE(study::has_own_map(project, *project.find("heavy")));
  EXPECT_TRUE(study::has_own_map(project, *project.find("strict")));
}

}  // namespace design_map_test
