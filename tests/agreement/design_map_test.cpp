// SPDX-License-Identifier: BSD-3-Clause
// Maps by poles and residues of designs as sums against every design assembled and searched separately.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "support/projects.h"
#include "trivet/judging/read_project.h"
#include "trivet/study/map/design_map.h"

namespace design_map_test {

using namespace trivet;

/// float has 24 bits; both methods find peaks more accurately than that.
constexpr double of_a_float = 2e-7;

project::Project paper() {
  const auto project = judging::read_project(std::string(TRIVET_SOURCE_DIR) + "/examples/paper/map.toml");
  EXPECT_TRUE(project);
  return *project;
}

study::DesignMap mapped(const project::Project& project, int nx, int ny, bool fast, int threads = 0) {
  return study::design_map(project, project.base(), *project.base().analyses.map, {nx, ny, {threads, fast}});
}

/// The governing rules may differ if their margins are equal.
void expect_equal(const study::DesignMap& lanes, const study::DesignMap& single) {
  ASSERT_EQ(lanes.outcomes.size(), single.outcomes.size());
  EXPECT_EQ(lanes.report.proven + lanes.report.fallback, lanes.outcomes.size());
  EXPECT_EQ(single.report.assembled_separately, single.outcomes.size());
  for (std::size_t k = 0; k < lanes.outcomes.size(); ++k) {
    const auto &a = lanes.outcomes[k], &b = single.outcomes[k];
    if (std::isinf(a.margin) || std::isinf(b.margin)) {
      EXPECT_EQ(a.margin, b.margin) << "design " << k;
      continue;
    }
    EXPECT_NEAR(a.margin, b.margin, of_a_float * b.margin)
        << "design " << k << ": " << lanes.rules[a.governing].words << " / " << single.rules[b.governing].words;
    EXPECT_EQ(a.feasible(), b.feasible()) << "design " << k;
  }
}

TEST(DesignMap, PaperIsTheSameDesignByDesign) {
  const project::Project project = paper();
  const study::DesignMap lanes = mapped(project, 7, 6, true), single = mapped(project, 7, 6, false);
  expect_equal(lanes, single);
  constexpr double boundary_error = 1e-5;  // boundaries are known to 1e-6 of each axis
  EXPECT_NEAR(lanes.feasible.area, single.feasible.area, boundary_error);
}

TEST(DesignMap, VelocitiesAndAccelerationsOfPointsAreTheSameDesignByDesign) {
  const project::Project project = test::project(test::chain({1.0, 2.0, 0.5}, {300, 500, 200, 0}, {2, 1, 3, 0}) + R"(
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

/// A light body on a heavy one: the rise of the light one depends on accelerations at the low resonances, which are a
/// hundred-millionth of the highest.
TEST(DesignMap, AccelerationsFarBelowTheHighestAreTheSameDesignByDesign) {
  const auto bushing = [](const std::string& name, const std::string& between, const std::string& at,
                          const std::string& translation) {
    return "[elements." + name + "]\ntype = \"bushing\"\n" + between + "\nat = " + at +
        "\ntranslation = " + translation + "\nscale = 1\ndamping = {proportional = 0.009}\n";
  };
  const project::Project project =
      test::project(R"(trivet = 1
[bodies.light]
mass = 1
center_of_mass = [0, 0, 0.2]
inertia = {about = "center_of_mass", xx = 0.2, yy = 0.2, zz = 0.2}
free = ["z", "rx", "ry"]
[bodies.heavy]
mass = 2000
center_of_mass = [0, 0, 0]
inertia = {about = "center_of_mass", xx = 500, yy = 600, zz = 700}
free = ["z", "rx", "ry"]
)" + bushing("a", "on = \"light\"", "[0, 0.6, 0]", "[1e3, 1e3, 1e3]") +
                    bushing("b", "on = \"light\"", "[0, 0, 0]", "[3e3, 3e3, 5e3]") +
                    bushing("c", "on = \"light\"", "[0.5, -0.9, 0]", "[2e3, 2e3, 4e3]") +
                    bushing("d", "on = \"heavy\"\nfrom = \"light\"", "[0, 0, 0]", "[7e5, 7e5, 1e6]") +
                    bushing("e", "on = \"heavy\"\nfrom = \"light\"", "[-0.8, -0.6, 0]", "[8e5, 8e5, 1e6]") +
                    bushing("f", "on = \"heavy\"", "[0, 0.5, 0]", "[3e5, 3e5, 5e5]") + R"(
[excitations.force]
type = "harmonic"
on = "light"
at = [0, 0, 0]
force = [-5, 0, 0.5]
moment = [-7, 0, 0]
[analyses.map]
x = {parameter = "elements.a.scale", from = 30, to = 33}
y = {parameter = "elements.b.scale", from = 0.736, to = 0.81}
no_peak = "light.z"
quantity = "acceleration"
)");
  expect_equal(mapped(project, 3, 3, true), mapped(project, 3, 3, false));
}

/// A force along the axis of three equal mounts moves a machine along this axis only: round-off in the other
/// coordinates is not a peak.
TEST(DesignMap, SymmetricMachineHasNoPeaksOfRoundOff) {
  std::string text = R"(trivet = 1
[bodies.machine]
mass = 250
center_of_mass = [0, 0, 0.1]
inertia = {about = "center_of_mass", xx = 8.1, yy = 12.4, zz = 13.0}
)";
  for (const double degrees : {0.0, 120.0, 240.0}) {
    const double angle = degrees / 180 * 3.14159265358979323846;
    text += fmt::format(
        "[elements.mount{:.0f}]\ntype = \"bushing\"\non = \"machine\"\nat = [{:.17g}, {:.17g}, 0]\ntranslation = "
        "[720e3, 720e3, 1680e3]\n"
        "rotation = [60, 60, 140]\ndamping = {{proportional = 0.05}}\n",
        degrees, 0.3 * std::cos(angle), 0.3 * std::sin(angle));
  }
  const project::Project project = test::project(text + R"(
[excitations.engine]
type = "harmonic"
on = "machine"
at = [0, 0, 0.2]
force = [0, 0, 120]
[analyses.map]
x = {parameter = "bodies.machine.mass", from = 200, to = 300}
y = {parameter = "bodies.machine.inertia.xx", from = 8, to = 9}
no_peak = "coordinates"
)");
  const study::DesignMap map = mapped(project, 5, 5, true);
  EXPECT_TRUE(std::ranges::all_of(map.outcomes,
                                  [](const design::DesignOutcome& o) { return std::isinf(o.margin) && o.feasible(); }));
  expect_equal(map, mapped(project, 5, 5, false));
}

TEST(DesignMap, IsTheSameByteForByteFor1And16Threads) {
  const project::Project project = paper();
  const study::DesignMap one = mapped(project, 40, 60, true, 1), many = mapped(project, 40, 60, true, 16);
  for (std::size_t k = 0; k < one.outcomes.size(); ++k) {
    EXPECT_EQ(one.outcomes[k].margin, many.outcomes[k].margin);
    EXPECT_EQ(one.outcomes[k].governing, many.outcomes[k].governing);
  }
  EXPECT_EQ(one.feasible.area, many.feasible.area);
}

TEST(DesignMap, JudgesACaseLikeTheDesignInItsPlace) {
  const project::Project project = paper();
  project::MapRequest request = *project.base().analyses.map;
  request.x.from = 1.5;  // the corner of the grid is Figure 7
  request.y.to = 0.2;
  const study::DesignMap map = study::design_map(project, project.base(), request, {2, 2, {}});
  const auto figure = std::ranges::find(map.marks, "Figure 7", &study::MapMark::name);
  ASSERT_NE(figure, map.marks.end());
  EXPECT_TRUE(figure->of_this_model);
  EXPECT_NEAR(figure->judged->governing.margin, map.outcomes[2].margin, of_a_float);
}

}  // namespace design_map_test
