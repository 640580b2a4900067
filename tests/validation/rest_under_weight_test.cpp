// SPDX-License-Identifier: BSD-3-Clause
// Positions of rest under a weight that changes the stiffness, with wind and without, in closed form.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/modal/modes.h"
#include "trivet/response/steady/at_rest.h"
#include "trivet/response/steady/static_response.h"

namespace rest_under_weight_test {

using namespace trivet;
using test::RelativelyNear;

constexpr double round_off = 1e-9, g = 9.80665;

std::map<std::string, double> at_rest(const std::string& text, const std::vector<std::string>& of) {
  const project::Project project = test::project(text);
  const model::System& system = project.base().system;
  const assembly::Assembled assembled = assembly::assemble(system);
  const response::AtRest rest(system, assembled);
  std::map<std::string, double> values;
  for (const response::StaticValue& one : response::static_response(rest.system(), rest.assembled(), of).values)
    values[one.name] = one.value;
  return values;
}

std::vector<double> squares(const std::string& text) {
  std::vector<double> all;
  for (const modal::Mode& mode : modal::modes(test::project(text).base().system).list)
    all.push_back(mode.eigenvalue_squared);
  return all;
}

std::string wind(const std::string& body, double height, double force) {
  return fmt::format("[excitations.wind]\ntype = \"constant\"\non = \"{}\"\nat = [0, 0, {}]\nforce = [{}, 0, 0]\n",
                     body, height, force);
}

/// 400 kg, its centre of mass 1.1 m over mounts of 46 N/mm at ± 0.25 m: gravity takes 38 % of the tilting stiffness.
const std::string cabinet = [] {
  std::string text =
      "trivet = 1\ngravity = [0, 0, -9.80665]\n[bodies.cabinet]\nmass = 400\ncenter_of_mass = [0, 0, 1.1]\ninertia = "
      "{about = \"center_of_mass\", xx = 180, yy = 170, zz = 30}\n";
  for (const auto& [name, x, y] : {std::tuple{"a", .25, .2}, {"b", .25, -.2}, {"c", -.25, .2}, {"d", -.25, -.2}})
    text += fmt::format(
        "[elements.{}]\ntype = \"bushing\"\non = \"cabinet\"\nat = [{}, {}, 0]\ntranslation = [1e5, 1e5, 4.6e4]\n",
        name, x, y);
  return text;
}();

TEST(RestUnderWeight, TiltsACabinetAgainstItsWeight) {
  const double restoring = 4 * 4.6e4 * 0.25 * 0.25, overturning = 400 * g * 1.1;
  const auto rest = at_rest(cabinet + wind("cabinet", 2.2, 200), {"cabinet", "a.force.z", "ground.force.x"});
  EXPECT_THAT(rest.at("cabinet.ry"), RelativelyNear(200 * 2.2 / (restoring - overturning), round_off));
  EXPECT_THAT(rest.at("cabinet.x"), RelativelyNear(200.0 / 4e5, round_off));
  EXPECT_THAT(rest.at("cabinet.z"), RelativelyNear(-400 * g / (4 * 4.6e4), round_off));
  EXPECT_THAT(rest.at("ground.force.x"), RelativelyNear(200, round_off));
  const double tilt = 200 * 2.2 / (restoring - overturning);
  EXPECT_THAT(rest.at("a.force.z"), RelativelyNear(-(400 * g / 4 + 4.6e4 * 0.25 * tilt), round_off));
}

TEST(RestUnderWeight, TiltsItByItsMountsAloneAsRequested) {
  const auto rest = at_rest("second_order = false\n" + cabinet + wind("cabinet", 2.2, 200), {"cabinet.ry"});
  EXPECT_THAT(rest.at("cabinet.ry"), RelativelyNear(200 * 2.2 / (4 * 4.6e4 * 0.25 * 0.25), round_off));
}

/// A weight alone is in balance where the file shows the machine, wherever its centre of mass is.
TEST(RestUnderWeight, IsThatOfTheDrawing) {
  std::string beside = cabinet;
  beside.replace(beside.find("[0, 0, 1.1]"), 11, "[0.05, 0, 1.1]");
  EXPECT_THAT(at_rest(beside, {"cabinet.ry"}).at("cabinet.ry"),
              RelativelyNear(400 * g * 0.05 / (4 * 4.6e4 * 0.25 * 0.25), round_off));
}

/// 50 kg on a hook that holds no moment, its centre of mass 0.8 m below.
std::string hung(double offset = 0) {
  return fmt::format(
      "trivet = 1\ngravity = [0, 0, -9.80665]\n[bodies.hoist]\nmass = 50\ncenter_of_mass = [{}, 0, -0.8]\ninertia = "
      "{{about = \"center_of_mass\", xx = 2, yy = 2, zz = 1}}\n[elements.hook]\ntype = \"three_springs\"\non = "
      "\"hoist\"\nat = [0, 0, 0]\ntranslation = [1e9, 1e9, 1e9]\n[elements.swivel]\ntype = \"bushing\"\non = "
      "\"hoist\"\nat = [0, 0, 0]\ntranslation = [0, 0, 0]\nrotation = [0, 0, 50]\n",
      offset);
}

/// The resultant of weight and wind passes through the hook: the sine of the angle is F/R.
TEST(RestUnderWeight, SwingsAHungBodyAside) {
  const auto rest = at_rest(hung() + wind("hoist", -0.8, 30), {"hoist", "hook.force.x"});
  EXPECT_THAT(rest.at("hoist.ry"), RelativelyNear(-30 / std::hypot(30, 50 * g), round_off));
  EXPECT_THAT(rest.at("hook.force.x"), RelativelyNear(30, round_off));
  EXPECT_THAT(at_rest(hung(), {"hoist.z"}).at("hoist.z"), RelativelyNear(-50 * g / 1e9, round_off));
}

/// All modes of a body that hangs beside the drawing are those of a pendulum under the resultant: two swings, and the
/// swivel about the hook.
TEST(RestUnderWeight, LeavesAHungBodyItsPendulum) {
  constexpr double of_the_turn = 1e-2;  // sixth of the square of 0.24 rad
  for (const double force : {0.0, 30.0, 120.0}) {
    const double resultant = std::hypot(force, 50 * g), pendulum = resultant * 0.8 / (2 + 50 * 0.64);
    std::vector<double> found = squares(hung() + wind("hoist", -0.8, force));
    found.resize(3);
    EXPECT_THAT(found,
                testing::ElementsAre(RelativelyNear(pendulum, of_the_turn), RelativelyNear(pendulum, of_the_turn),
                                     RelativelyNear(50, 4 * of_the_turn)))
        << force;
  }
}

/// Its centre of mass hangs beside the hook: it swings under it, however weak what else holds it.
TEST(RestUnderWeight, HangsUnderItsHook) {
  for (const double swivel : {0.0, 1.0}) {
    std::string text = hung(0.1);
    text.replace(text.find("rotation = [0, 0, 50]"), 21, fmt::format("rotation = [0, {}, 50]", swivel));
    // m g (0.1 cos φ − 0.8 sin φ) = swivel sin φ; a soft spring is linear in the sine here
    const double turn = at_rest(text, {"hoist.ry"}).at("hoist.ry");
    const double level = 0.1 * std::sqrt(1 - turn * turn) - 0.8 * turn - swivel * turn / (50 * g);
    EXPECT_NEAR(level, 0, 1e-3 * 0.1) << turn;  // third order of the turn
    const double pendulum = 50 * g * std::hypot(0.8, 0.1) / (2 + 50 * 0.65);
    EXPECT_THAT(squares(text), testing::Contains(RelativelyNear(pendulum, 1e-2)));
  }
}

/// The free swing of a machine on a hook of skew springs does not depend on the pole of its body.
TEST(RestUnderWeight, HangsPlumbAboutEveryPole) {
  for (const double pole : {0.0, -0.8, 2.0}) {
    const std::string text = fmt::format(
        "trivet = 1\ngravity = [0, 0, -9.80665]\n[bodies.hoist]\nmass = 50\nposition = [0, 0, {0}]\ncenter_of_mass = "
        "[0, 0, {1}]\ninertia = {{about = \"center_of_mass\", xx = 2, yy = 2, zz = 1}}\n[elements.hook]\ntype = "
        "\"three_springs\"\non = \"hoist\"\nat = [0, 0, {2}]\norientation = {{axis = \"y\", angle = 0.3}}\ntranslation "
        "= [2e4, 3e4, 5e4]\n[elements.swivel]\ntype = \"bushing\"\non = \"hoist\"\nat = [0, 0, {2}]\ntranslation = [0, "
        "0, 0]\nrotation = [0, 0, 50]\n",
        pole, -0.8 - pole, -pole);
    EXPECT_NEAR(at_rest(text, {"hoist.ry"}).at("hoist.ry"), 0, 1e-12) << pole;
  }
}

/// So far aside that the drawing says nothing about its rest: left at first order, and said so.
TEST(RestUnderWeight, LeavesABodyFarAsideAtFirstOrder) {
  const project::Project project = test::project(hung() + wind("hoist", -0.8, 200));
  EXPECT_THAT(assembly::assemble(project.base().system).without_rest, testing::ElementsAre(0u));
}

/// Two mounts of rubber, one above and one below the centre of mass, share the weight by their static stiffnesses.
TEST(RestUnderWeight, IsSharedByTheStaticStiffness) {
  const std::string text =
      "trivet = 1\ngravity = [0, 0, -9.80665]\n[bodies.b]\nmass = 100\nfree = [\"z\", \"ry\"]\ninertia = {about = "
      "\"center_of_mass\", xx = 3, yy = 3, zz = 3}\n[elements.above]\ntype = \"bushing\"\non = \"b\"\nat = [0, 0, "
      "0.4]\ntranslation = [1, 1, 1e5]\nstiffening = 1\n[elements.below]\ntype = \"bushing\"\non = \"b\"\nat = [0, 0, "
      "-0.4]\ntranslation = [1, 1, 3e5]\nstiffening = 2\n[elements.upright]\ntype = \"bushing\"\non = "
      "\"b\"\nat = [0, 0, 0]\ntranslation = [0, 0, 0]\nrotation = [0, 2000, 0]\n";
  const double above = 100 * g / 4, below = 3 * above;  // static stiffnesses are the numbers of the file
  const double stiffness = 2000 + (1 + 2) * 0.16 + 0.4 * (above - below);
  EXPECT_THAT(
      squares(text),
      testing::ElementsAre(RelativelyNear(stiffness / 3, round_off), RelativelyNear((1e5 + 6e5) / 100, round_off)));
}

}  // namespace rest_under_weight_test
