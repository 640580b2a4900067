// SPDX-License-Identifier: BSD-3-Clause
// Rigid bodies on mounts against closed forms and equilibrium.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/judging/read_project.h"

namespace reference_bodies_test {

using namespace trivet;
using test::RelativelyNear;

TEST(FourMounts, SymmetricBlockOfTheHandbook) {
  // Harris/Crede, Shock and Vibration Handbook ch. 3: two planes of symmetry, mounts below the centre of mass;
  // biquadratics.
  constexpr double all_digits = 1e-10;  // of six coordinates; the biquadratics have all digits
  const double expected[] = {5.695217703488748, 5.887912913343855,  9.003163161571061,
                             9.724527652599994, 12.470146321689391, 13.26030984710917};
  std::string text =
      "trivet = 1\n[bodies.block]\nmass = 1000\ninertia = {about = \"center_of_mass\", xx = 180, yy = 390, zz = 450}\n";
  for (const int x : {-1, 1})
    for (const int y : {-1, 1})
      text += fmt::format(
          "[elements.\"{} {}\"]\ntype = \"three_springs\"\non = \"block\"\nat = [{}, {}, -0.4]\ntranslation = [4e5, "
          "5e5, 8e5]\n",
          x, y, 0.8 * x, 0.5 * y);
  const modal::Modes modes = modal::modes(test::project(text).base().system);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_THAT(*modes.list[i].angular_frequency / (2 * std::numbers::pi), RelativelyNear(expected[i], all_digits));
}

TEST(Static, ThreeMountsCarryTheForcesOfEquilibrium) {
  constexpr double all_digits = 1e-9;       // equilibrium, solved separately with all digits
  constexpr double of_a_difference = 1e-7;  // of larger terms
  const std::string text = R"(
trivet = 1
gravity = [0, 0, -9.80665]
[bodies.plate]
mass = 205
center_of_mass = [0.03, -0.02, 0.25]
inertia = {about = "center_of_mass", xx = 10, yy = 11, zz = 12}
[elements.a]
type = "three_springs"
on = "plate"
at = [0.4, 0.3, 0]
translation = [90000, 90000, 220000]
[elements.b]
type = "three_springs"
on = "plate"
at = [-0.4, 0.3, 0]
translation = [90000, 90000, 260000]
[elements.c]
type = "three_springs"
on = "plate"
at = [0, -0.35, 0]
translation = [80000, 80000, 300000]
[analyses]
static = {}
)";
  const auto project = test::project(text);
  const study::CaseResults results = study::case_results(project.base(), project.base().analyses);
  const auto found = [&](const std::string& name) {
    return std::ranges::find_if(results.statics->values, [&](const auto& v) { return v.name == name; })->value;
  };
  EXPECT_THAT(found("plate.z"), RelativelyNear(-0.0026897977325498093, all_digits));
  EXPECT_THAT(found("plate.rx"), RelativelyNear(0.0017407425956452326, all_digits));
  EXPECT_THAT(found("plate.ry"), RelativelyNear(0.0012368762599179665, all_digits));
  EXPECT_THAT(found("a.force.z"), RelativelyNear(-585.7116007211537, all_digits));
  EXPECT_THAT(found("b.force.z"), RelativelyNear(-434.93435697115376, all_digits));
  EXPECT_THAT(found("c.force.z"), RelativelyNear(-989.7172923076922, all_digits));
  EXPECT_THAT(found("ground.force.z"), RelativelyNear(-205 * 9.80665, all_digits));
  EXPECT_THAT(found("ground.moment.x"), RelativelyNear(-205 * 9.80665 * -0.02, of_a_difference));
}

struct Inertia {
  const char* name;
  double xy, zz;
  std::array<double, 3> central;
  bool physical;
};

TEST(Inertia, ImpossibleOnesAreRejectedAndTheCorrectedOneIsAccepted) {
  // Central principal moments computed outside this project; with Jz = 132.853 one is −0.0085 kg m².
  constexpr double round_off = 1e-7;  // kg m²: 1e-9 of the largest moment
  for (const Inertia& given :
       {Inertia{"printed", 66.194, 32.853, {-98.74761912698347, 0.30447956327340475, 5.077435051710137}, false},
        Inertia{"Jz = 132.853", 66.194, 132.853, {-0.008504177212864299, 1.5402070104394974, 5.102592654773437}, false},
        Inertia{"corrected", 65.194, 135.853, {0.8669833105936766, 4.189478850480125, 4.57783332692627}, true}}) {
    const std::string text = fmt::format(
        "trivet = 1\n[bodies.b]\nmass = 205.176\ncenter_of_mass = [-0.624, -0.502, -0.226]\n"
        "inertia = {{about = \"pole\", xx = 66.289, yy = 91.643, zz = {}, xy = {}, xz = 28.935, yz = 23.973}}\n",
        given.zz, given.xy);
    const auto refused_or_not = judging::project_from_text(text, "test.toml");
    EXPECT_EQ(refused_or_not.has_value(), given.physical) << given.name;
    const auto allowed = judging::project_from_text(text + "allow_unphysical = true\n", "test.toml");
    ASSERT_TRUE(allowed.has_value());
    EXPECT_EQ(allowed->base().warnings.list().empty(), given.physical) << given.name;
    const Eigen::Vector3d moments = spatial::principal_inertia(allowed->base().system.bodies()[0].mass).moments;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(moments(i), given.central[i], round_off) << given.name;
    if (!given.physical) {
      const auto& list = refused_or_not.error().list();
      EXPECT_TRUE(std::ranges::any_of(list, [](const auto& p) {
        return p.rule.find("5 positive and 1 negative") != std::string::npos;
      })) << given.name;
    }
  }
}

}  // namespace reference_bodies_test
