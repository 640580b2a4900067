// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "support/projects.h"
#include "trivet/study/best_design.h"
#include "trivet/study/design_map.h"
#include "trivet/study/map_json.h"

namespace {

using namespace trivet;

constexpr float unlimited = std::numeric_limits<float>::infinity();

/// Margins of a grid from a function of the nodes.
std::vector<study::DesignOutcome> outcomes(const study::MapGrid& grid, const std::function<float(int, int)>& margin) {
  std::vector<study::DesignOutcome> all;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) all.push_back({margin(i, j), 0});
  return all;
}

TEST(BestDesign, HasTheLargestMargin) {
  const study::MapGrid grid{4, 3};
  const auto found = study::best_design(study::drawn_grid(grid), outcomes(grid, [](int i, int j) { return 2 + 0.1F * float(i) - 0.01F * float(j); }));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->design, grid.index(3, 0));
  EXPECT_EQ(found->without_bound, 0u);
  EXPECT_EQ(found->equals, 1u);
}

TEST(BestDesign, StandsInTheMidstOfEquals) {
  const study::MapGrid grid{21, 21};  // a plateau from the right frame inwards
  const auto found = study::best_design(study::drawn_grid(grid), outcomes(grid, [](int i, int j) { return i >= 12 && j >= 5 && j <= 11 ? 3.0F : 2.0F; }));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->equals, 63u);
  EXPECT_EQ(found->design / 21, 8u);
  EXPECT_EQ(found->without_bound, 0u);
}

TEST(BestDesign, StandsInTheMiddleOfAStrip) {
  const study::MapGrid grid{21, 21};
  const auto found = study::best_design(study::drawn_grid(grid), outcomes(grid, [](int i, int j) { return i == 20 && j >= 4 && j <= 14 ? 3.0F : 2.0F; }));
  EXPECT_EQ(found->design, grid.index(20, 9));
}

TEST(BestDesign, StandsInTheMidstOfThoseWithoutBound) {
  const study::MapGrid grid{21, 21};  // without bound: a disc of 5 nodes about (12, 9)
  const auto found = study::best_design(study::drawn_grid(grid), outcomes(grid, [](int i, int j) { return std::hypot(i - 12, j - 9) < 5.5 ? unlimited : 2.0F; }));
  EXPECT_EQ(found->design, grid.index(12, 9));
  EXPECT_EQ(found->without_bound, 97u);
}

TEST(BestDesign, KeepsAwayFromTheFrameWhereNothingIsLimited) {
  const study::MapGrid grid{11, 21};
  const auto found = study::best_design(study::drawn_grid(grid), outcomes(grid, [](int, int) { return unlimited; }));
  EXPECT_EQ(found->design % 11, 5u);
}

TEST(BestDesign, OfAFineGridIsOneOfItsOwnDesigns) {
  const study::MapGrid grid{1000, 500};
  const auto all = outcomes(grid, [](int i, int j) { return std::hypot((i - 700) / 1000.0, (j - 200) / 500.0) < 0.2 ? unlimited : 1.0F; });
  const auto found = study::best_design(study::drawn_grid(grid), all);
  EXPECT_NEAR(static_cast<double>(found->design % 1000), 700, 5);
  EXPECT_NEAR(static_cast<double>(found->design / 1000), 200, 3);
  EXPECT_TRUE(std::isinf(all[found->design].margin));
}

TEST(BestDesign, IsNoneWithoutAnyModel) {
  const study::MapGrid grid{2, 2};
  EXPECT_FALSE(study::best_design(study::drawn_grid(grid), std::vector<study::DesignOutcome>(4, {0, study::DesignOutcome::no_model})));
}

TEST(DrawnGrid, HoldsBothEndsAndPutsPlacesOntoTheMap) {
  const study::DrawnGrid drawn = study::drawn_grid({1000, 100});
  EXPECT_EQ(drawn.columns.size(), 241u);
  EXPECT_EQ(drawn.rows.size(), 100u);
  EXPECT_EQ(drawn.columns.front(), 0);
  EXPECT_EQ(drawn.columns.back(), 999);
  const study::MapGrid nodes = drawn.nodes();
  for (const int k : {0, 1, 100, 239, 240}) EXPECT_NEAR(drawn.on_map(nodes.place(k, 0)).x, drawn.columns[static_cast<std::size_t>(k)] / 999.0, 1e-15);
}

TEST(MarginLines, LieWhereTheMarginIsAlsoOnAFineGrid) {
  const study::MapGrid grid{700, 500};
  const auto all = outcomes(grid, [](int i, int j) { return static_cast<float>(std::exp(0.9 * i / 699 + 0.4 * j / 499)); });
  const auto lines = study::margin_lines(study::drawn_grid(grid), all, std::exp(1.3));
  ASSERT_FALSE(lines.empty());
  for (const study::MarginLine& margin : lines)
    for (const study::MapLine& line : margin.lines)
      for (const study::MapPlace& p : line) EXPECT_NEAR(std::exp(0.9 * p.x + 0.4 * p.y), margin.margin, 1e-5);  // float nodes
}

TEST(MarginLines, EndBesideDesignsWithoutBound) {
  const study::MapGrid grid{41, 41};
  const auto all = outcomes(grid, [](int i, int j) { return i + j > 50 ? unlimited : static_cast<float>(std::exp(0.05 * i)); });
  const auto lines = study::margin_lines(study::drawn_grid(grid), all, unlimited);
  ASSERT_FALSE(lines.empty());
  for (const study::MarginLine& margin : lines)
    for (const study::MapLine& line : margin.lines)
      for (const study::MapPlace& p : line) EXPECT_NEAR(std::exp(2 * p.x), margin.margin, 1e-5) << "a step along the border of what has no bound";
}

TEST(MarginLines, EndWhereTheyWouldLieCloserThanTheDesigns) {
  const study::MapGrid grid{41, 41};
  const auto all = outcomes(grid, [](int i, int j) { return i + j < 30 ? 0.9F : static_cast<float>(1.4 * std::exp(0.02 * i)); });  // a cliff from 0.9 to 1.4 … 3.1
  const auto lines = study::margin_lines(study::drawn_grid(grid), all, 3.1);
  ASSERT_FALSE(lines.empty());
  for (const study::MarginLine& margin : lines)
    for (const study::MapLine& line : margin.lines)
      for (const study::MapPlace& p : line) EXPECT_NEAR(1.4 * std::exp(0.8 * p.x), margin.margin, 1e-5) << "a step along the cliff";
}

TEST(MissingKinds, AreMessagesWithoutTheirNumbers) {
  EXPECT_EQ(study::without_numbers("mass = -5.25e-3 kg of mount2; a mass must be > 0"), "mass = # kg of mount2; a mass must be > #");
  EXPECT_EQ(study::without_numbers("eigenvalues 1.5, 3 and 4e+05"), study::without_numbers("eigenvalues -2, 77.125 and 1"));
  EXPECT_NE(study::without_numbers("element a1: 3"), study::without_numbers("element a2: 3"));
}

/// A body whose inertia breaks the triangle inequality, each design by other figures.
TEST(DesignMap, GroupsDesignsWithoutAModelByKind) {
  const study::Project project = test::project(R"(
trivet = 1
[bodies.block]
mass = 10
inertia = {about = "center_of_mass", xx = 1, yy = 1, zz = 1}
[elements.mount]
type = "bushing"
on = "block"
at = [0.1, 0.2, 0.3]
translation = [900, 1100, 1300]
rotation = [90, 80, 70]
damping = {proportional = 0.05}
[excitations.force]
type = "harmonic"
on = "block"
at = [0, 0, 0]
force = [1, 2, 3]
[analyses.map]
x = {parameter = "bodies.block.inertia.xx", from = 1, to = 9, points = 9}
y = {parameter = "bodies.block.mass", from = -10, to = 20, points = 7}
no_peak = "coordinates"
)");
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
  std::size_t missing = 0;
  for (const study::MissingReason& reason : map.report.missing) missing += reason.designs;
  EXPECT_EQ(missing, map.unknown);
  EXPECT_GT(map.unknown, 20u);
  EXPECT_LE(map.report.missing.size(), 3u);
}

TEST(DesignMap, CountsDesignsByTheWayTheyWereJudged) {
  const study::Project project = *study::read_project(std::string(TRIVET_SOURCE_DIR) + "/examples/paper/map.toml");
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map, {30, 30, {}});
  EXPECT_EQ(map.report.proven + map.report.redone + map.report.one_by_one, 900u);
  EXPECT_GT(map.report.proven, 800u);
}

const std::string with_cases = R"(
trivet = 1
[bodies.machine]
mass = 10
free = ["z"]
[elements.spring]
type = "bushing"
on = "machine"
at = [0, 0, 0]
translation = [1000, 1000, 1000]
damping = {proportional = 0.05}
[excitations.force]
type = "harmonic"
on = "machine"
at = [0, 0, 0]
force = [0, 0, 10]
[analyses.map]
x = {parameter = "elements.spring.scale", from = 0.5, to = 2, points = 3}
y = {parameter = "elements.spring.damping.proportional", from = 0.01, to = 0.3, points = 3}
no_peak = "coordinates"
[cases.point]
elements.spring.scale = 1.5
[cases.heavy]
bodies.machine.mass = 20
[cases.strict]
analyses.map.peak_tolerance = 0
)";

TEST(DesignMap, OfACaseIsItsOwnWhereTheCaseChangesTheQuestion) {
  const study::Project project = test::project(with_cases);
  EXPECT_TRUE(study::has_own_map(project, project.base()));
  EXPECT_FALSE(study::has_own_map(project, *project.find("point")));
  EXPECT_FALSE(study::has_own_map(project, *project.find("heavy")));
  EXPECT_TRUE(study::has_own_map(project, *project.find("strict")));
}

TEST(DesignMap, SaysThatRowsOfAnswersChangeWhereTheyForbidTheFastWay) {
  const study::Project project = test::project(with_cases, {"analyses.map.limits={\"spring.force.z\"=30}"});
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
  EXPECT_EQ(map.report.one_by_one, 9u);
  EXPECT_THAT(map.report.words(), testing::HasSubstr("rows change from design to design"));
}

}  // namespace
