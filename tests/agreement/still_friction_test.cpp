// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <string>

#include "support/projects.h"
#include "trivet/foundation/constants.h"
#include "trivet/nonlinear/branch/steady_branch.h"

/// Friction in directions that do not move: in a symmetric machine forces across the drive cancel, and their round-off
/// must neither end a curve nor change it.
namespace still_friction_test {

using namespace trivet;
using foundation::two_pi;

std::string machine(const std::string& law, bool in_all_directions, const std::string& sideways = "0") {
  std::string laws;
  for (const std::string axis : {"x", "y", "z"})
    if (in_all_directions || axis == "z") laws += "laws." + axis + " = {" + law + "}\n";
  std::string text = R"(trivet = 1
gravity = [0, 0, -9.80665]
[bodies.p]
mass = 260
center_of_mass = [0, 0, 0.22]
inertia = {about = "center_of_mass", xx = 12, yy = 24, zz = 22}
[element_types.rope]
type = "bushing"
translation = [70e3, 70e3, 120e3]
rotation = [20, 20, 20]
damping = {proportional = "0.3 ms"}
)" + laws +
      R"([tables.elements]
rows = [
  {name = "a", type = "rope", on = "p", at = [0.5, 0.25, 0]},
  {name = "b", type = "rope", on = "p", at = [-0.5, 0.25, 0]},
  {name = "c", type = "rope", on = "p", at = [0.5, -0.25, 0]},
  {name = "d", type = "rope", on = "p", at = [-0.5, -0.25, 0]}]
[excitations.sea]
type = "base"
translation = [)" +
      sideways + R"(, 0, 2.5]
quantity = "acceleration"
)";
  return text;
}

nonlinear::SteadyBranch followed(const std::string& text, double from, double to) {
  nonlinear::SteadyOptions options;
  options.from = two_pi * from;
  options.to = two_pi * to;
  options.harmonics = 5;
  options.of = {"p.z", "p.x"};
  options.at = {two_pi * 2, two_pi * 6, two_pi * 7};
  return nonlinear::steady_branch(test::project(text).base().system, options);
}

const std::string bouc_wen = "bouc_wen = {stiffness = 60e3, force = 250}",
                  berg = "friction = {berg = {force = 250, deflection = 2e-3}}";

TEST(StillFriction, ChangesNothingInASymmetricMachine) {
  constexpr double of_round_off = 1e-7;  // Newton's method stops at 1e-11 of the deflections
  for (const std::string& law : {bouc_wen, berg}) {
    const nonlinear::SteadyBranch in_all = followed(machine(law, true), 1, 8),
                                  upright = followed(machine(law, false), 1, 8);
    EXPECT_EQ(in_all.ended, "") << law;
    ASSERT_EQ(in_all.at.size(), 3u) << law;
    ASSERT_EQ(upright.at.size(), 3u) << law;
    for (std::size_t i = 0; i < 3; ++i) {
      const nonlinear::ObservedMotion &one = in_all.at[i].results[0], &other = upright.at[i].results[0];
      EXPECT_NEAR(one.half_of_range() / other.half_of_range(), 1, of_round_off) << law;
      EXPECT_NEAR(one.mean, other.mean, of_round_off * other.half_of_range()) << law;
      EXPECT_LT(in_all.at[i].results[1].half_of_range(), of_round_off * other.half_of_range()) << law;
    }
  }
}

/// Of m d'' + c d' + k d + F z = −m a cos ωt with dz/dd = (k₀/F) (1 − (1 + sgn(z ḋ)) |z|/2), the four mounts together,
/// and the ground below: integrated in time (the method RK45 of SciPy, relative tolerance 1e-10) over 60
/// periods. Three harmonics leave out 1e-4 of it.
TEST(StillFriction, HasTheMotionOfOneCoordinateInTime) {
  constexpr double left_out = 3e-4;
  const nonlinear::SteadyBranch found = followed(machine(bouc_wen, true), 1, 8);
  ASSERT_EQ(found.at.size(), 3u);
  EXPECT_NEAR(found.at[0].results[0].half_of_range() / 16.81461e-3, 1, left_out);
  EXPECT_NEAR(found.at[1].results[0].half_of_range() / 3.75852e-3, 1, left_out);
  EXPECT_NEAR(found.at[2].results[0].half_of_range() / 5.18304e-3, 1, left_out);
}

/// A small motion to the side is no round-off: with a share of 4e-4 of the drive, as in a ship that rolls a little.
TEST(StillFriction, MovesWhereTheDriveHasASmallShare) {
  const nonlinear::SteadyBranch found = followed(machine(bouc_wen, true, "1e-3"), 5, 8);
  EXPECT_EQ(found.ended, "");
  ASSERT_EQ(found.at.size(), 2u);
  constexpr double above_round_off = 1e-7;  // [m]: that of motions of millimetres is below 1e-9
  EXPECT_GT(found.at[0].results[1].half_of_range(), above_round_off);
}

}  // namespace still_friction_test
