// SPDX-License-Identifier: BSD-3-Clause
// Maps by poles and residues of interpolated matrices against every design assembled and searched by itself.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "support/projects.h"
#include "trivet/study/design_map.h"

namespace {

using namespace trivet;

/// float holds 24 bits; both ways find peaks to better than that.
constexpr double of_a_float = 2e-7;

study::Project paper() {
  const auto project = study::read_project(std::string(TRIVET_SOURCE_DIR) + "/examples/paper/map.toml");
  EXPECT_TRUE(project);
  return *project;
}

study::DesignMap mapped(const study::Project& project, int nx, int ny, bool fast, int threads = 0) {
  return study::design_map(project, project.base(), *project.base().analyses.map, {nx, ny, {threads, fast}});
}

/// Rules may exchange where their margins are equal.
void expect_equal(const study::DesignMap& lanes, const study::DesignMap& single) {
  ASSERT_EQ(lanes.outcomes.size(), single.outcomes.size());
  EXPECT_EQ(lanes.report.proven + lanes.report.redone, lanes.outcomes.size());
  EXPECT_EQ(single.report.one_by_one, single.outcomes.size());
  for (std::size_t k = 0; k < lanes.outcomes.size(); ++k) {
    const auto &a = lanes.outcomes[k], &b = single.outcomes[k];
    if (std::isinf(a.margin) || std::isinf(b.margin)) {
      EXPECT_EQ(a.margin, b.margin) << "design " << k;
      continue;
    }
    EXPECT_NEAR(a.margin, b.margin, of_a_float * b.margin) << "design " << k << ": " << lanes.rules[a.governing].words << " / " << single.rules[b.governing].words;
    EXPECT_EQ(a.kept(), b.kept()) << "design " << k;
  }
}

TEST(DesignMap, OfThePaperIsTheSameDesignByDesign) {
  const study::Project project = paper();
  const study::DesignMap lanes = mapped(project, 7, 6, true), single = mapped(project, 7, 6, false);
  expect_equal(lanes, single);
  EXPECT_NEAR(lanes.feasible.area, single.feasible.area, 1e-5);
}

TEST(DesignMap, OfVelocitiesAndAccelerationsOfPointsIsTheSameDesignByDesign) {
  const study::Project project = test::project(test::chain({1.0, 2.0, 0.5}, {300, 500, 200, 0}, {2, 1, 3, 0}) + R"(
[excitations.force]
type = "harmonic"
on = "m1"
at = [0, 0, 0]
force = [10, 0, 0]
[analyses.map]
x = {parameter = "bodies.m2.mass", from = 1, to = 4}
y = {parameter = "elements.k1.scale", from = 0.5, to = 3}
band = [0, 60]
limits = {"m1.x" = "0.5 m/s", "m2.x" = ["60 mm", "9 m/s2"], "m3.x" = "20 m/s2"}
no_peak = ["m3"]
)");
  expect_equal(mapped(project, 6, 5, true), mapped(project, 6, 5, false));
}

TEST(DesignMap, IsTheSameByteForByteFor1And16Threads) {
  const study::Project project = paper();
  const study::DesignMap one = mapped(project, 40, 60, true, 1), many = mapped(project, 40, 60, true, 16);
  for (std::size_t k = 0; k < one.outcomes.size(); ++k) {
    EXPECT_EQ(one.outcomes[k].margin, many.outcomes[k].margin);
    EXPECT_EQ(one.outcomes[k].governing, many.outcomes[k].governing);
  }
  EXPECT_EQ(one.feasible.area, many.feasible.area);
}

TEST(DesignMap, JudgesACaseLikeTheDesignInItsPlace) {
  const study::Project project = paper();
  study::MapRequest request = *project.base().analyses.map;
  request.x.from = 1.5;  // the corner of the grid is Figure 7
  request.y.to = 0.2;
  const study::DesignMap map = study::design_map(project, project.base(), request, {2, 2, {}});
  const auto figure = std::find_if(map.marks.begin(), map.marks.end(), [](const study::MapMark& m) { return m.name == "Figure 7"; });
  ASSERT_NE(figure, map.marks.end());
  EXPECT_TRUE(figure->of_this_model);
  EXPECT_NEAR(figure->judged->governing.margin, map.outcomes[2].margin, of_a_float);
}

}  // namespace
