// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "support/projects.h"
#include "trivet/modal/modes.h"
#include "trivet/response/steady/visible_amplitudes.h"

namespace vanishing_ends_test {

using namespace trivet;
using assembly::MotionQuantity;

/// A block with its centre of mass above its mount, excited at the mount by `course`.
std::string block(const std::string& course) {
  return R"(trivet = 1
[bodies.block]
mass = 10
center_of_mass = [0, 0, 0.1]
inertia = {about = "center_of_mass", xx = 0.35, yy = 0.42, zz = 0.3}
[elements.spring]
type = "bushing"
on = "block"
at = [0, 0, 0]
translation = [10000, 10000, 20000]
rotation = [500, 500, 500]
damping = {translation = [500, 500, 500], rotation = [30, 30, 30]}
[excitations.course]
)" + course;
}

std::vector<bool> ends(const std::string& text, const std::vector<std::string>& names, MotionQuantity quantity) {
  const project::Project project = test::project(text);
  const model::System& system = project.base().system;
  const assembly::Assembled assembled = assembly::assemble(system);
  return response::vanish_at_both_ends(assembled, assembly::channels(system, assembled, names, quantity),
                                       assembly::harmonic_loading(system, assembled), modal::roots(system));
}

const std::string force = "type = \"harmonic\"\non = \"block\"\nat = [0, 0, 0]\nforce = [10, 0, 0]\n";
const std::string unbalance =
    "type = \"unbalance\"\non = \"block\"\nat = [0, 0, 0]\naxis = \"x\"\nmass_eccentricity = \"10 g mm\"\n";
const std::string ground = "type = \"base\"\ntranslation = [0, 0, 0.001]\n";

TEST(CurveEnds, TheTiltUnderAForceAtThePoleVanishesAtBoth) {
  EXPECT_THAT(ends(block(force), {"block.x", "block.ry", "block.z"}, MotionQuantity::displacement),
              testing::ElementsAre(false, true, false));
}

TEST(CurveEnds, VelocitiesUnderAForceVanishAtBothAndAccelerationsDoNot) {
  EXPECT_THAT(ends(block(force), {"block.x", "block.ry", "block.z"}, MotionQuantity::velocity),
              testing::ElementsAre(true, true, false));
  EXPECT_THAT(ends(block(force), {"block.x", "block.ry", "block.z"}, MotionQuantity::acceleration),
              testing::ElementsAre(false, false, false));
}

TEST(CurveEnds, TheMotionUnderAnUnbalanceDoesNotVanishAtBoth) {
  for (const MotionQuantity quantity :
       {MotionQuantity::displacement, MotionQuantity::velocity, MotionQuantity::acceleration})
    EXPECT_THAT(ends(block(unbalance), {"block.z"}, quantity), testing::ElementsAre(false))
        << static_cast<int>(quantity);
}

TEST(CurveEnds, TheVelocityOverADamperOnMovingGroundDoesNotVanishAtBoth) {
  EXPECT_THAT(ends(block(ground), {"block.z"}, MotionQuantity::velocity), testing::ElementsAre(false));
  std::string without = block(ground);
  without.erase(without.find("damping"), without.find("[excitations") - without.find("damping"));
  EXPECT_THAT(ends(without, {"block.z"}, MotionQuantity::velocity), testing::ElementsAre(true));
}

TEST(CurveEnds, TheDriftOfAFreeBodyDoesNotVanishAtRest) {
  const std::string free =
      "trivet = 1\n[bodies.block]\nmass = 10\ninertia = {about = \"center_of_mass\", xx = 0.35, yy = 0.42, zz = "
      "0.3}\ncenter_of_mass = [0, 0, 0]\n[excitations.course]\n" +
      force;
  EXPECT_THAT(ends(free, {"block.x"}, MotionQuantity::displacement), testing::ElementsAre(false));
  EXPECT_THAT(ends(free, {"block.x"}, MotionQuantity::velocity), testing::ElementsAre(false));
}

/// Towards rest the motion along a free direction with a force becomes larger than every other.
TEST(CurveEnds, OtherDirectionsThanAPushedFreeOneDoNotVanishAtBoth) {
  const std::string sled = R"(trivet = 1
[bodies.block]
mass = 6
center_of_mass = [0, 0, 0]
free = ["x", "y", "z"]
[elements.spring]
type = "bushing"
on = "block"
at = [0, 0, 0]
translation = [0, 3e3, 3e6]
damping = {translation = [0, 1, 200]}
[excitations.course]
type = "harmonic"
on = "block"
at = [0, 0, 0]
force = [1, 1, 1]
)";
  EXPECT_THAT(ends(sled, {"block.x", "block.y", "block.z"}, MotionQuantity::displacement),
              testing::ElementsAre(false, false, false));
}

TEST(CurveEnds, APointWithoutMotionDoesNotVanishAtBoth) {
  std::string undamped = block(force);
  undamped.replace(undamped.find("force = [10, 0, 0]"), 18, "force = [0, 0, 10]");
  undamped.erase(undamped.find("damping"), undamped.find("[excitations") - undamped.find("damping"));
  undamped.replace(undamped.find("mass = 10"), 9, "mass = 16");
  undamped.replace(undamped.find("20000]"), 5, "160000");
  undamped.insert(undamped.find("[elements"),
                  "free = [\"z\"]\npoints.top = [0, 0, 0.2]\n");  // a single natural frequency, 100 rad/s
  EXPECT_THAT(ends(undamped, {"block.top.z", "block.top.x"}, MotionQuantity::velocity),
              testing::ElementsAre(true, false));
}

TEST(CurveEnds, AFractionalLawHasNoEndAtInfinity) {
  std::string fractional = block(force);
  const std::size_t at = fractional.find("damping");
  fractional.replace(at, fractional.find("[excitations") - at,
                     "damping = {fractional_zener = {ratio = 3, time = \"1 ms\", order = 0.5}}\n");
  EXPECT_THAT(ends(fractional, {"block.x"}, MotionQuantity::velocity), testing::ElementsAre(false));
}

}  // namespace vanishing_ends_test
