// SPDX-License-Identifier: BSD-3-Clause
// Wind, thrust and torque on machines that their weight has brought to rest, in closed form.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/modal/modes.h"
#include "trivet/response/steady/at_rest.h"
#include "trivet/response/steady/static_response.h"

namespace loads_beside_weight_test {

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

TEST(LoadsBesideWeight, TiltACabinetAgainstItsWeight) {
  const double restoring = 4 * 4.6e4 * 0.25 * 0.25, overturning = 400 * g * 1.1;
  const auto rest = at_rest(cabinet + wind("cabinet", 2.2, 200), {"cabinet", "a.force.z", "ground.force.x"});
  EXPECT_THAT(rest.at("cabinet.ry"), RelativelyNear(200 * 2.2 / (restoring - overturning), round_off));
  EXPECT_THAT(rest.at("cabinet.x"), RelativelyNear(200.0 / 4e5, round_off));
  EXPECT_THAT(rest.at("cabinet.z"), RelativelyNear(-400 * g / (4 * 4.6e4), round_off));
  EXPECT_THAT(rest.at("ground.force.x"), RelativelyNear(200, round_off));
  const double tilt = 200 * 2.2 / (restoring - overturning);
  EXPECT_THAT(rest.at("a.force.z"), RelativelyNear(-(400 * g / 4 + 4.6e4 * 0.25 * tilt), round_off));
}

TEST(LoadsBesideWeight, TiltItByItsMountsAloneAsAsked) {
  const auto rest = at_rest("second_order = false\n" + cabinet + wind("cabinet", 2.2, 200), {"cabinet.ry"});
  EXPECT_THAT(rest.at("cabinet.ry"), RelativelyNear(200 * 2.2 / (4 * 4.6e4 * 0.25 * 0.25), round_off));
}

/// A weight alone is in balance where the file shows the machine, wherever its centre of mass is.
TEST(LoadsBesideWeight, AreNotTheWeight) {
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

TEST(LoadsBesideWeight, SwingAHungBodyAside) {
  const auto rest = at_rest(hung() + wind("hoist", -0.8, 30), {"hoist", "hook.force.x"});
  EXPECT_THAT(rest.at("hoist.ry"), RelativelyNear(-30 / (50 * g), round_off));
  EXPECT_THAT(rest.at("hook.force.x"), RelativelyNear(30, round_off));
  EXPECT_THAT(at_rest(hung(), {"hoist.z"}).at("hoist.z"), RelativelyNear(-50 * g / 1e9, round_off));
}

TEST(LoadsBesideWeight, LeaveAHungBodyItsPendulum) {
  constexpr double of_the_hook = 1e-5;  // its stiffness lets the pivot move by this share of ω²
  const double pendulum = 50 * g * 0.8 / (2 + 50 * 0.64);
  EXPECT_THAT(squares(hung() + wind("hoist", -0.8, 30)), testing::Contains(RelativelyNear(pendulum, of_the_hook)));
}

/// The centre of mass hangs beside the hook: it swings under it, and keeps its pendulum.
TEST(LoadsBesideWeight, AreThoseThatTheWeightLeaves) {
  constexpr double across = 1e-6;  // offset² / height² stays below
  EXPECT_THAT(at_rest(hung(1e-4), {"hoist.ry"}).at("hoist.ry"), RelativelyNear(1e-4 / 0.8, across));
  const double pendulum = 50 * g * 0.8 / (2 + 50 * 0.64);
  EXPECT_THAT(squares(hung(1e-4)), testing::Contains(RelativelyNear(pendulum, 1e-5)));
}

/// So far aside that the drawing says nothing about its rest: left at first order, and said so.
TEST(LoadsBesideWeight, LeaveABodyFarAsideAtFirstOrder) {
  const project::Project project = test::project(hung() + wind("hoist", -0.8, 200));
  EXPECT_THAT(assembly::assemble(project.base().system).without_rest, testing::ElementsAre(0u));
}

/// Two mounts of rubber, one above and one below the centre of mass, share the weight by their static stiffnesses.
TEST(LoadsBesideWeight, AreSharedByTheStaticStiffness) {
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

}  // namespace loads_beside_weight_test
