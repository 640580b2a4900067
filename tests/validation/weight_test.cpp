// SPDX-License-Identifier: BSD-3-Clause
// Machines whose weight changes their stiffness, in closed form: pendulums, upright and hung, and a tall cabinet.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/judging/read_project.h"
#include "trivet/modal/modes.h"

namespace weight_test {

using namespace trivet;
using test::RelativelyNear;

constexpr double round_off = 1e-9;  // of squares of frequencies, where large terms nearly cancel
constexpr double g = 9.80665;

std::vector<double> squares(const std::string& text) {
  const project::Project project = test::project(text);
  std::vector<double> all;
  for (const modal::Mode& mode : modal::modes(project.base().system).list) all.push_back(mode.eigenvalue_squared);
  return all;
}

/// 80 kg on a joint at the pole that turns about x, its centre of mass at the height h over it.
std::string pendulum(double h, const std::string& joint) {
  return fmt::format(
             "trivet = 1\ngravity = [0, 0, -9.80665]\n[bodies.p]\nmass = 80\ncenter_of_mass = [0, 0, {}]\nfree = "
             "[\"rx\"]\ninertia = {{about = \"center_of_mass\", xx = 9, yy = 9, zz = 4}}\n",
             h) +
      joint;
}

TEST(Weight, ActsOnAPendulumOnABushing) {
  const std::string bushing =
      "[elements.b]\ntype = \"bushing\"\non = \"p\"\nat = [0, 0, 0]\ntranslation = [1e5, 1e5, 1e5]\nrotation = "
      "[2000, 1, 1]\n";
  for (const double h : {1.2, 0.3, -0.5, -2.0})
    EXPECT_THAT(squares(pendulum(h, bushing)),
                testing::ElementsAre(RelativelyNear((2000 - 80 * g * h) / (9 + 80 * h * h), round_off)));
}

TEST(Weight, HoldsAPendulumOnAHinge) {
  EXPECT_THAT(squares(pendulum(-0.7, "")),
              testing::ElementsAre(RelativelyNear(80 * g * 0.7 / (9 + 80 * 0.49), round_off)));
}

/// On a cord, the tension of which is the weight: a pendulum with the cord's length.
TEST(Weight, TensionsALink) {
  const std::string text =
      "trivet = 1\ngravity = [0, 0, -9.80665]\n[bodies.p]\nmass = 80\nfree = [\"x\", \"z\"]\n[elements.cord]\ntype = "
      "\"link\"\non = \"p\"\nat = [0, 0, 0]\naxis = [0, 0, -1]\nlength = 1.5\nstiffness = 1e6\n";
  EXPECT_THAT(squares(text),
              testing::ElementsAre(RelativelyNear(g / 1.5, round_off), RelativelyNear(1e6 / 80, round_off)));
}

/// 800 kg over mounts at ±0.22 m, of which those at x > 0 are stiffer; its centre of mass is where they sag alike.
struct Cabinet {
  double height, k_left = 5e4, k_right = 5e4, lateral = 6e4;

  [[nodiscard]] double offset() const { return 0.22 * (k_right - k_left) / (k_right + k_left); }
  [[nodiscard]] std::string text() const {
    std::string all = fmt::format(
        "trivet = 1\ngravity = [0, 0, -9.80665]\n[bodies.cabinet]\nmass = 800\ncenter_of_mass = [{}, 0, {}]\ninertia = "
        "{{about = \"center_of_mass\", xx = 420, yy = 420, zz = 90}}\n",
        offset(), height);
    int number = 0;
    for (const double x : {-0.22, 0.22})
      for (const double y : {-0.22, 0.22})
        all += fmt::format(
            "[elements.m{}]\ntype = \"bushing\"\non = \"cabinet\"\nat = [{}, {}, 0]\ntranslation = [{}, {}, {}]\n",
            ++number, x, y, lateral, lateral, x < 0 ? k_left : k_right);
    return all;
  }
};

/// ω² of a body that sways and tilts: m ẍ and J about its centre of mass at the height h, against k at the mounts.
std::array<double, 2> swaying(double m, double j, double h, double lateral, double tilting) {
  // det [k − ω² m, −ω² m h; −ω² m h, κ − m g h − ω² (J + m h²)] = 0.
  const double held = tilting - m * g * h, a = m * j, b = -(m * held + lateral * (j + m * h * h)), c = lateral * held;
  const double root = -0.5 * (b - std::sqrt(b * b - 4 * a * c));
  const double high = root / a;
  return {c / (a * high), high};
}

TEST(Weight, SoftensATallCabinet) {
  const auto [low, high] = swaying(800, 420, 0.8, 24e4, 4 * 5e4 * 0.22 * 0.22);
  const std::vector<double> found = squares(Cabinet{.height = 0.8}.text());
  EXPECT_THAT(found,
              testing::ElementsAre(RelativelyNear(low, round_off), RelativelyNear(low, round_off),
                                   RelativelyNear(200e3 / 800, round_off),
                                   RelativelyNear(24e4 * 2 * 0.22 * 0.22 / 90, round_off),
                                   RelativelyNear(high, round_off), RelativelyNear(high, round_off)));
  EXPECT_NEAR(std::sqrt(found[0]) / (2 * std::numbers::pi), 0.303, 5e-4);  // Hz; without its weight 0.508
}

TEST(Weight, StiffensAHungMachine) {
  const auto [low, high] = swaying(800, 420, -1.4, 24e4, 4 * 5e4 * 0.22 * 0.22);
  EXPECT_THAT(squares(Cabinet{.height = -1.4}.text()),
              testing::ElementsAre(RelativelyNear(low, round_off), RelativelyNear(low, round_off),
                                   RelativelyNear(200e3 / 800, round_off),
                                   RelativelyNear(24e4 * 2 * 0.22 * 0.22 / 90, round_off),
                                   RelativelyNear(high, round_off), RelativelyNear(high, round_off)));
}

/// Unequal mounts under a centre of mass off the middle: two planes with different tilting stiffnesses. About the place
/// over which it sags evenly the mounts do not couple heave and pitch.
TEST(Weight, SoftensACabinetOnUnequalMountsInBothPlanes) {
  const Cabinet cabinet{.height = 0.8, .k_left = 3e4, .k_right = 7e4};
  double pitching = 0;
  for (const auto& [x, k] : {std::pair{-0.22, cabinet.k_left}, {0.22, cabinet.k_right}})
    pitching += 2 * k * std::pow(x - cabinet.offset(), 2);
  const auto pitch = swaying(800, 420, 0.8, 24e4, pitching);
  const std::vector<double> found = squares(cabinet.text());
  for (const double expected : {pitch[0], pitch[1], 200e3 / 800})
    EXPECT_THAT(found, testing::Contains(RelativelyNear(expected, round_off)));
}

TEST(Weight, IsLeftOutToSecondOrderAsRequested) {
  const auto [low, high] = swaying(800, 420, 0.8, 24e4, 4 * 5e4 * 0.22 * 0.22 + 800 * g * 0.8);
  EXPECT_THAT(squares("second_order = false\n" + Cabinet{.height = 0.8}.text()),
              testing::Contains(RelativelyNear(low, round_off)));
  static_cast<void>(high);
}

/// 9,680 N m/rad of the mounts against 10,983 N m/rad of the weight.
TEST(Weight, MakesACabinetFallOver) {
  const auto refused = judging::project_from_text(Cabinet{.height = 1.4}.text(), "cabinet.toml", {}, "");
  ASSERT_FALSE(refused);
  ASSERT_EQ(refused.error().list().size(), 1u);
  const foundation::Problem& problem = refused.error().list().front();
  EXPECT_EQ(problem.severity, foundation::Severity::error);
  EXPECT_EQ(problem.subject, "bodies.cabinet");
  EXPECT_THAT(problem.finding,
              testing::HasSubstr("it falls over: when it tilts, the weight causes an overturning "
                                 "moment of 10.983 kN m/rad, the elements a restoring moment of 9.68 "
                                 "kN m/rad; with its centre of mass below 1.234 m over its pole"));
  EXPECT_TRUE(judging::project_from_text(Cabinet{.height = 1.233}.text(), "cabinet.toml", {}, ""));
  EXPECT_FALSE(judging::project_from_text(Cabinet{.height = 1.235}.text(), "cabinet.toml", {}, ""));
}

}  // namespace weight_test
