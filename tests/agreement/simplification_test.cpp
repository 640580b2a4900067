// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/explain/simplification.h"

#include <gmock/gmock.h>

#include <cmath>

#include "support/projects.h"
#include "trivet/elements/stiffness_properties.h"

namespace simplification_test {

using trivet::study::ModeComparison;
using trivet::study::Simplification;

/// Both modes come from the same symmetric eigensolver: its round-off over the gap of stiffnesses.
constexpr double round_off = 1e-11;

const std::string body = R"(trivet = 1
[bodies.mass]
mass = 50
center_of_mass = [0, 0, 0]
inertia = {about = "center_of_mass", xx = 2, yy = 3, zz = 4}
)";

const std::string coil = R"([elements.spring]
type = "coil_spring"
on = "mass"
at = [0, 0, 0]
axis = "z"
wire_diameter = "12 mm"
mean_diameter = "120 mm"
active_coils = 7.6
free_length = "394 mm"
material = "spring_steel"
)";

/// Three springs at K with an arm of 0.2 m, given as a full 6×6 in skew axes.
const std::string three_springs_as_matrix = R"([elements.spring]
type = "matrix"
on = "mass"
at = [0.1, 0.2, 0.3]
from_at = [0.1, 0.2, 0.1]
orientation = {axis = [1, 1, 0], angle = "0.7 rad"}
stiffness = [[1e5, 0, 0, 0, 0, 0], [0, 2e5, 0, 0, 0, 0], [0, 0, 3e5, 0, 0, 0],
             [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0]]
damping = {loss_factor = 0.1}
[elements.holder]
type = "bushing"
on = "mass"
at = [-0.1, 0, 0]
translation = [2e4, 3e4, 4e4]
rotation = [100, 200, 300]
damping = {loss_factor = 0.1}
[excitations.engine]
type = "harmonic"
on = "mass"
at = [0, 0.1, 0]
force = [1, 2, 3]
)";

/// The mode with `words` in its name.
const ModeComparison& named(const Simplification& simple, const std::string& words) {
  for (const ModeComparison& mode : simple.modes)
    if (mode.name.find(words) != std::string::npos) return mode;
  ADD_FAILURE() << "no mode " << words;
  return simple.modes.front();
}

TEST(Simplification, ChangesNothingForAMatrixThatIsThreeSprings) {
  const auto project = trivet::test::project(body + three_springs_as_matrix);
  const Simplification simple = trivet::study::simplification(project.base(), {0});
  ASSERT_EQ(simple.modes.size(), 6u);
  for (const ModeComparison& mode : simple.modes) {
    EXPECT_NEAR(*trivet::study::relative_difference(mode.full, mode.simplified), 0, round_off) << mode.name;
    EXPECT_NEAR(mode.similarity, 1, round_off) << mode.name;
  }
  ASSERT_EQ(simple.peaks.size(), 6u);
  constexpr double settled = 1e-9;  // last step of Newton's method for a peak
  for (const auto& peak : simple.peaks)
    EXPECT_NEAR(peak.simplified->amplitude / peak.full->amplitude, 1, settled) << peak.name;
  EXPECT_TRUE(simple.free_motions.empty());
}

TEST(Simplification, KeepsTheBounceOfACoilSpringAndLosesItsTilting) {
  const auto project = trivet::test::project(body + coil);
  const Simplification simple = trivet::study::simplification(project.base(), {0});
  const auto& stiffness = project.base().system.elements()[0].law.nominal_stiffness;
  constexpr double helix_coupling = 1e-3;  // of the vertical with other directions
  // On a single spring the vertical stiffness alone determines the bounce, except for the coupling of the helix itself.
  const ModeComparison& bounce = named(simple, "translation along z");
  EXPECT_NEAR(*bounce.simplified, std::sqrt(stiffness(8, 8) / 50), round_off * *bounce.simplified);
  EXPECT_NEAR(*trivet::study::relative_difference(bounce.full, bounce.simplified), 0, helix_coupling);
  int free = 0;
  for (const ModeComparison& mode : simple.modes) {
    EXPECT_TRUE(mode.full && *mode.full > 0) << mode.name;
    free += mode.simplified && *mode.simplified == 0;
  }
  EXPECT_EQ(free, 3);
  EXPECT_EQ(simple.free_motions.size(), 3u);
}

TEST(Simplification, IsTheModelWrittenWithThreeSprings) {
  const auto full = trivet::test::project(body + coil);
  const auto& stiffness = full.base().system.elements()[0].law.nominal_stiffness;
  const Simplification simple = trivet::study::simplification(full.base(), {0});
  char text[300];
  std::snprintf(text, sizeof text,
                "[elements.spring]\ntype = \"three_springs\"\non = \"mass\"\nat = [0, 0, 0]\ntranslation = [%.17g, "
                "%.17g, %.17g]\n",
                stiffness(6, 6), stiffness(7, 7), stiffness(8, 8));
  const auto written = trivet::test::project(body + text);
  const auto modes = trivet::modal::modes(written.base().system);
  std::vector<double> expected, found;
  for (const auto& mode : modes.list) expected.push_back(*mode.angular_frequency);
  for (const ModeComparison& mode : simple.modes) found.push_back(*mode.simplified);
  std::ranges::sort(found);
  EXPECT_THAT(found, testing::Pointwise(testing::DoubleNear(round_off * expected.back()), expected));
}

TEST(Simplification, KeepsTheKindOfDampingAndTheScale) {
  const auto project = trivet::test::project(body + three_springs_as_matrix, {"elements.spring.scale=1.5"});
  const auto simplified = trivet::study::with_three_springs(project.base().system, {0, 1});
  EXPECT_EQ(simplified.elements()[0].law.scale, 1.5);
  EXPECT_EQ(trivet::elements::loss_factor(simplified.elements()[1].law), 0.1);
  EXPECT_EQ(simplified.elements()[1].law.nominal_stiffness.diagonal().tail<3>().norm(), 0);
}

TEST(RelativeDifference, IsMissingIfANumberIsMissing) {
  EXPECT_EQ(trivet::study::relative_difference(2.0, 3.0), 0.5);
  EXPECT_EQ(trivet::study::relative_difference(2.0, 0.0), -1.0);
  EXPECT_EQ(trivet::study::relative_difference(0.0, 0.0), std::nullopt);
  EXPECT_EQ(trivet::study::relative_difference(std::nullopt, 1.0), std::nullopt);
  EXPECT_EQ(trivet::study::relative_difference(1.0, INFINITY), std::nullopt);
}

}  // namespace simplification_test
