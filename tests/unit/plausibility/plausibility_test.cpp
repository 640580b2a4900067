// SPDX-License-Identifier: BSD-3-Clause
// Features of bodies against closed forms, corrected slips, and single rules at their bounds.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/projects.h"
#include "trivet/assembly/assembled.h"
#include "trivet/judging/read_project.h"
#include "trivet/judging/suspicions.h"
#include "trivet/plausibility/overturning.h"
#include "trivet/plausibility/unit_slips.h"

namespace plausibility_test {

using namespace trivet;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double round_off = 1e-12;  // a few operations on numbers of equal size
constexpr double pi = std::numbers::pi;

/// A steel cube of 1 m on four equal springs at the corners of its lower face. With a slip it may fall over, which is
/// an error of its own.
struct Cube {
  double mass = 7850, inertia = 7850.0 / 6, places = 1, stiffness = 2e6, centre = 0.5;
  std::string about = "center_of_mass", gravity = "second_order = false\ngravity = [0, 0, -9.80665]", more, of_body,
              of_mount, damping = "damping = {loss_factor = 0.1}";

  [[nodiscard]] std::string text() const {
    std::string result = fmt::format(
        "trivet = 1\n{}\n[bodies.cube]\nmass = {}\ncenter_of_mass = [0, 0, {}]\ninertia = {{about = \"{}\", xx = {}, "
        "yy = {}, zz = {}}}\n{}\n",
        gravity, mass, centre, about, inertia, inertia, inertia, of_body);
    int number = 0;
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5})
        result += fmt::format(
            "[elements.mount{}]\ntype = \"bushing\"\non = \"cube\"\nat = [{}, {}, 0]\ntranslation = [{}, {}, "
            "{}]\n{}\n{}\n",
            ++number, x * places, y * places, stiffness, stiffness, stiffness, damping, of_mount);
    return result + more;
  }
};

std::vector<std::string> kinds(const std::string& text) {
  std::vector<std::string> found;
  const project::Project project = test::project(text);
  for (const auto& suspicion : judging::suspicions(project.base(), assembly::AssembledOnce(project.base().system)))
    found.push_back(suspicion.kind);
  return found;
}

plausibility::BodyPicture picture(const project::Project& project) {
  return plausibility::pictures(project.base().system, {false}, {false}).front();
}

TEST(Plausibility, FeaturesOfACubeAgreeWithClosedForms) {
  const project::Project project = test::project(Cube{}.text());
  const plausibility::Features found = plausibility::features(picture(project), {});
  const double omega = std::sqrt(4 * 2e6 / 7850);
  EXPECT_NEAR(*found.density, 7850, 7850 * round_off);
  EXPECT_NEAR(*found.spread, std::sqrt(0.75) / 0.5, round_off);  // half the space diagonal over half an edge
  EXPECT_NEAR(*found.frequency, omega / (2 * pi), round_off * omega);
  EXPECT_NEAR(*found.sag, 9.80665 / (omega * omega), round_off);
  // Σ k r² about three axes: 4 k (y² + z²), 4 k (x² + z²), 4 k (x² + y²)
  EXPECT_NEAR(*found.lever, std::sqrt(4 * 1.5 / 2 / 4) / 0.5, round_off);
  EXPECT_FALSE(found.damping_ratio.has_value());
}

/// All mounts are at the centre of mass, so that an element of rotations alone holds the cube against rotation: √(k/J).
TEST(Plausibility, AnElementOfRotationsAloneHoldsABody) {
  Cube cube;
  cube.centre = cube.places = 0;
  cube.more =
      "[elements.bar]\ntype = \"bushing\"\non = \"cube\"\nat = [0, 0, 0]\ntranslation = [0, 0, 0]\n"
      "rotation = [1e5, 2e5, 3e5]\n";
  const plausibility::Features found = plausibility::features(picture(test::project(cube.text())), {});
  EXPECT_NEAR(*found.lowest, std::sqrt(1e5 / cube.inertia) / (2 * pi), round_off);
}

TEST(Plausibility, ACorrectedSlipGivesTheFeaturesOfTheIntendedMachine) {
  const project::Project meant = test::project(Cube{}.text());
  const plausibility::Features sound = plausibility::features(picture(meant), {});
  constexpr double correction_round_off = 1e-9;  // of factors and of sums over mounts; a slip is a factor of 10 or more
  const auto expect_same = [&](const Cube& slipped, const plausibility::Slip& undone) {
    const project::Project project = test::project(slipped.text());
    const plausibility::Features found = plausibility::features(picture(project), undone);
    for (const auto feature :
         {&plausibility::Features::density, &plausibility::Features::spread, &plausibility::Features::lever,
          &plausibility::Features::frequency, &plausibility::Features::sag})
      EXPECT_NEAR(*(found.*feature), *(sound.*feature), correction_round_off * *(sound.*feature)) << undone.kind;
    EXPECT_NEAR(*found.lowest, *sound.lowest, correction_round_off * *sound.lowest);
    EXPECT_NEAR(*found.highest, *sound.highest, correction_round_off * *sound.highest);
  };
  expect_same({.mass = 7.85}, {.kind = "mass", .mass = 1e3});
  expect_same({.inertia = 7850.0 / 6 * 1e4}, {.kind = "inertia", .inertia = 1e-4});
  expect_same({.places = 1000}, {.kind = "places", .places = 1e-3});
  expect_same({.stiffness = 2e3}, {.kind = "stiffness", .stiffness = 1e3});
  expect_same({.centre = 500}, {.kind = "center of mass", .centre = 1e-3});
}

TEST(Plausibility, NamesOneKindForOneSlip) {
  EXPECT_THAT(kinds(Cube{}.text()), IsEmpty());
  EXPECT_THAT(kinds(Cube{.mass = 7850e3}.text()), ElementsAre("mass"));
  EXPECT_THAT(kinds(Cube{.mass = 7.85}.text()), ElementsAre("mass"));
  EXPECT_THAT(kinds(Cube{.inertia = 7850.0 / 6 * 1e4}.text()), ElementsAre("inertia"));
  EXPECT_THAT(kinds(Cube{.inertia = 7850.0 / 6 * 1e9}.text()), ElementsAre("inertia"));
  EXPECT_THAT(kinds(Cube{.inertia = 7850.0 / 6 / 1e3}.text()), ElementsAre("inertia"));
  EXPECT_THAT(kinds(Cube{.places = 1000}.text()), ElementsAre("places"));
  EXPECT_THAT(kinds(Cube{.places = 100}.text()), ElementsAre("places"));
  EXPECT_THAT(kinds(Cube{.stiffness = 2e3}.text()), ElementsAre("stiffness"));
  EXPECT_THAT(kinds(Cube{.stiffness = 2e10}.text()), ElementsAre("stiffness"));
  EXPECT_THAT(kinds(Cube{.centre = 500}.text()), ElementsAre("center of mass"));
}

TEST(Plausibility, DetectsGravityInOtherUnitsAndUpwards) {
  for (const char* gravity :
       {"[0, 0, -1]", "[0, 0, -9806.65]", "[0, 0, -980.665]", "[0, 0, -32.174]", "[0, 0, 9.80665]", "[0, 0, -1e4]"})
    EXPECT_THAT(kinds(Cube{.gravity = std::string("second_order = false\ngravity = ") + gravity}.text()),
                ElementsAre("gravity"))
        << gravity;
  for (const char* gravity : {"[0, 0, -9.81]", "[0, 0, -1.62]", "[-9.80665, 0, 0]", "[0, 0, -29.4]"})
    EXPECT_THAT(kinds(Cube{.gravity = std::string("second_order = false\ngravity = ") + gravity}.text()), IsEmpty())
        << gravity;
  // z down: the cube is above its mounts, at negative z
  EXPECT_THAT(kinds(Cube{.centre = -0.5, .gravity = "gravity = [0, 0, 9.80665]"}.text()), IsEmpty());
}

TEST(Plausibility, DetectsDampingInPercentAndExchanged) {
  EXPECT_THAT(kinds(Cube{.damping = "damping = {loss_factor = 0.59}"}.text()), IsEmpty());
  EXPECT_THAT(kinds(Cube{.damping = "damping = {loss_factor = 0.6}"}.text()), ElementsAre("loss factor"));
  EXPECT_THAT(kinds(Cube{.damping = "damping = {proportional = 1.2}"}.text()), ElementsAre("proportional damping"));
  EXPECT_THAT(kinds(Cube{.damping = "damping = {proportional = 0.8}"}.text()), ElementsAre("proportional damping"));
  EXPECT_THAT(kinds(Cube{.more = "[damping]\nmodal = 0.3\n", .damping = ""}.text()), IsEmpty());
  EXPECT_THAT(kinds(Cube{.more = "[damping]\nmodal = 2\n", .damping = ""}.text()), ElementsAre("modal damping"));
  EXPECT_THAT(kinds(Cube{.more = "[damping]\nrayleigh = {mass = 2, stiffness = 4e-4}\n", .damping = ""}.text()),
              IsEmpty());
  EXPECT_THAT(kinds(Cube{.more = "[damping]\nrayleigh = {mass = 4e-4, stiffness = 2}\n", .damping = ""}.text()),
              ElementsAre("rayleigh"));
}

TEST(Plausibility, DetectsAMountThatIsNotLikeTheOthers) {
  const std::string fifth = "[elements.fifth]\ntype = \"bushing\"\non = \"cube\"\ndamping = {loss_factor = 0.1}\n";
  EXPECT_THAT(kinds(Cube{.more = fifth + "at = [0, 0, 0]\ntranslation = [1e5, 1e5, 1e5]\n"}.text()), IsEmpty());
  EXPECT_THAT(kinds(Cube{.more = fifth + "at = [0, 0, 0]\ntranslation = [2e3, 2e3, 2e3]\n"}.text()),
              ElementsAre("stiffness"));
  EXPECT_THAT(kinds(Cube{.more = fifth + "at = [0, 0, 0]\ntranslation = [2e8, 2e8, 2e8]\n"}.text()),
              ElementsAre("unequal mounts"));
  EXPECT_THAT(kinds(Cube{.more = fifth + "at = [0.5, 0.5, 0]\ntranslation = [2e6, 2e6, 2e6]\n"}.text()),
              ElementsAre("same place"));
  EXPECT_THAT(kinds(Cube{.more = fifth + "at = [500, 0.5, 0]\ntranslation = [2e6, 2e6, 2e6]\n"}.text()),
              ElementsAre("places"));
  EXPECT_THAT(kinds(Cube{.more = fifth + "at = [0, 0, 0]\ntranslation = [2e6, 2e6, 2e6]\nrotation = [35, 35, 35]\n",
                         .of_mount = "rotation = [2000, 2000, 2000]"}
                        .text()),
              ElementsAre("stiffness per degree"));
}

TEST(Plausibility, DetectsALoadThatTipsOrLifts) {
  const auto moved = [](double x) {
    return fmt::format(
        "position = [0, 0, 0]\npoints.p = [0, 0, 1]\n[bodies.block]\nmass = 20000\nposition = [{}, 0, 1]\ninertia = "
        "{{about = \"center_of_mass\", xx = 4000, yy = 4000, zz = 4000}}\n[elements.upper]\ntype = \"bushing\"\non = "
        "\"block\"\nat = [0, 0, 0]\nfrom = \"cube\"\ntranslation = [2e7, 2e7, 2e7]\nrotation = [2e7, 2e7, 2e7]\n",
        x);
  };
  EXPECT_THAT(kinds(Cube{.of_body = moved(0.3)}.text()), IsEmpty());
  EXPECT_THAT(kinds(Cube{.of_body = moved(1)}.text()), ElementsAre("tipping"));
  const std::string beam =
      "[elements.column]\ntype = \"beam\"\non = \"cube\"\nat = [1.2, 0, 0]\nlength = 0.5\nsection = {round = "
      "0.1}\nmaterial = {E = 2.1e11, nu = 0.3, density = 7850}\n";
  EXPECT_THAT(kinds(Cube{.more = beam, .of_body = moved(1)}.text()), IsEmpty()) << "a column bears it";
  const std::string moment =
      "[excitations.torque]\ntype = \"constant\"\non = \"cube\"\nat = [0, 0, 0.5]\nmoment = [0, {}, 0]\n";
  EXPECT_THAT(kinds(Cube{.more = fmt::format(fmt::runtime(moment), 3e4)}.text()),
              IsEmpty());  // m g a/2 = 38.5 kN m lifts a side
  EXPECT_THAT(kinds(Cube{.more = fmt::format(fmt::runtime(moment), 5e4)}.text()), ElementsAre("lift-off"));
}

TEST(Plausibility, DetectsProportionalDampingThatOverdamps) {
  const double frequency = std::sqrt(4 * 2e6 / 7850) / (2 * pi);  // π f δ = 2
  const auto damped = [&](double ratio) {
    return Cube{.damping = fmt::format("damping = {{proportional = {}}}", ratio / (pi * frequency))}.text();
  };
  EXPECT_THAT(kinds(damped(1.99)), IsEmpty());
  EXPECT_THAT(kinds(damped(2.01)), ElementsAre("proportional damping"));
}

TEST(Plausibility, DetectsScalesInPercent) {
  EXPECT_THAT(kinds(Cube{.stiffness = 2e6 / 29, .of_mount = "scale = 29"}.text()), IsEmpty());
  EXPECT_THAT(kinds(Cube{.stiffness = 2e6 / 30, .of_mount = "scale = 30"}.text()), ElementsAre("scale"));
}

TEST(Plausibility, DetectsLimitsLargerThanTheBody) {
  const double size = 2 * std::sqrt(3 * (7850.0 / 6) / (2 * 7850));  // twice the root mean square distance of the mass
  const auto limited = [](double amplitude) {
    return Cube{.more = fmt::format("[excitations.push]\ntype = \"harmonic\"\non = \"cube\"\nat = [0, 0, 0.5]\nforce = "
                                    "[0, 0, 1]\n[analyses]\nresponse = {{of = \"cube\"}}\n[limits]\n\"cube.z\" = {}\n",
                                    amplitude)}
        .text();
  };
  EXPECT_THAT(kinds(limited(0.99 * size)), IsEmpty());
  EXPECT_THAT(kinds(limited(1.01 * size)), ElementsAre("limit"));
}

TEST(Plausibility, DetectsOneDamperOfThree) {
  const auto dampers = [](double last) {
    std::string text;
    for (int i = 0; i < 3; ++i)
      text += fmt::format(
          "[elements.d{}]\ntype = \"damper\"\non = \"cube\"\nat = [{}, 0, 0]\naxis = \"z\"\ncoefficient = {}\n", i, i,
          i == 2 ? last : 1e4);
    return Cube{.more = text}.text();
  };
  EXPECT_THAT(kinds(dampers(1e4 / 49)), IsEmpty());
  EXPECT_THAT(kinds(dampers(1e4 / 51)), ElementsAre("viscous damping"));
}

TEST(Plausibility, CorrectsStiffnessTogetherWithTheDampingOfItsLaw) {
  EXPECT_THAT(kinds(Cube{.stiffness = 2e3, .damping = "damping = {kelvin_voigt = {time = \"0.6 ms\"}}"}.text()),
              ElementsAre("stiffness"));
}

TEST(Plausibility, DetectsRimsThatBurst) {
  // A steel cylinder twice as long as thick, r³ = m / 4πρ: 100 kg have 0.1004 m, 600 m/s are 5975 rad/s.
  const double radius = std::cbrt(100 / (4 * pi * 7850));
  const auto rotor = [&](double rim) {
    return fmt::format(
        "[excitations.rotor]\ntype = \"unbalance\"\non = \"cube\"\nat = [0, 0, 0.5]\naxis = \"x\"\ngrade = "
        "6.3\nrotor_mass = 100\nservice_speed = \"{} rad/s\"\n",
        rim / radius);
  };
  EXPECT_THAT(kinds(Cube{.more = rotor(599)}.text()), IsEmpty());
  EXPECT_THAT(kinds(Cube{.more = rotor(601)}.text()), ElementsAre("speed"));
}

TEST(Plausibility, DetectsEndsTypedInTheFrameOfTheBody) {
  const auto end = [](double z) { return fmt::format("from_at = [0.5, 0.5, {}]", z); };
  // `from_at` in the frame of the body instead of the ground is only possible for a body with a position.
  const std::string position = "position = [0, 0, 1.2]";
  std::string text = Cube{.of_body = position}.text();
  EXPECT_THAT(kinds(text), IsEmpty());
  text +=
      "[elements.post]\ntype = \"bushing\"\non = \"cube\"\nat = [0.5, 0.5, 0]\ntranslation = [3e6, 3e6, 3e6]\ndamping "
      "= {loss_factor = 0.1}\n";
  EXPECT_THAT(kinds(text + end(-0.05)), testing::Contains("places"));
  EXPECT_THAT(kinds(text + end(1.15)), testing::Not(testing::Contains("places")));
}

std::vector<std::string> overturning_notes(const std::string& text) {
  const project::Project project = test::project(text);
  return plausibility::overturning_notes(project.base().system, assembly::assemble(project.base().system));
}

TEST(Plausibility, DetectsAMachineThatFallsOver) {
  // Four springs of 20 N/mm at ±0.2 m: k = 4 · 20e3 · 0.2² = 3200 N m/rad against m g h.
  const auto rack = [](double h) {
    std::string text = fmt::format(
        "trivet = 1\ngravity = [0, 0, -9.81]\n[bodies.rack]\nmass = 300\ncenter_of_mass = [0, 0, {}]\ninertia = "
        "{{about = \"center_of_mass\", xx = 60, yy = 60, zz = 20}}\n",
        h);
    int number = 0;
    for (const double x : {-0.2, 0.2})
      for (const double y : {-0.2, 0.2})
        text += fmt::format(
            "[elements.m{}]\ntype = \"bushing\"\non = \"rack\"\nat = [{}, {}, 0]\ntranslation = [2e4, 2e4, 2e4]\n",
            ++number, x, y);
    return text;
  };
  EXPECT_THAT(overturning_notes(rack(0.27)), IsEmpty());  // 24.8 %
  EXPECT_THAT(overturning_notes(rack(0.28)), ElementsAre(testing::HasSubstr("26 % of the stiffness is lost")));
  EXPECT_THAT(overturning_notes(rack(1.08)), ElementsAre(testing::HasSubstr("99 % of the stiffness is lost")));
  const auto refused = judging::project_from_text(rack(1.09), "rack.toml", {}, "");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().list().front().finding,
              testing::HasSubstr("of 3.2079 kN m/rad, the elements a restoring moment of 3.2 kN m/rad"));
  EXPECT_THAT(overturning_notes(rack(-1)), IsEmpty());
}

TEST(Plausibility, MeasuresTheHeightAboveTheMountsThatCarryWeight) {
  // 300 kg on four feet of 25.6 kN/m at ±0.2 m (k = 4096 N m/rad) and a lateral guide at another height, which carries
  // no weight: only the feet count.
  const auto guided = [](double feet, double guide) {
    std::string text =
        "trivet = 1\ngravity = [0, 0, -9.81]\n[bodies.rack]\nmass = 300\ninertia = {about = \"center_of_mass\", xx = "
        "60, yy = 60, zz = 20}\n";
    int number = 0;
    for (const double x : {-0.2, 0.2})
      for (const double y : {-0.2, 0.2})
        text += fmt::format(
            "[elements.m{}]\ntype = \"bushing\"\non = \"rack\"\nat = [{}, {}, {}]\ntranslation = [1, 1, 25600]\n",
            ++number, x, y, feet);
    text += fmt::format(
        "[elements.guide]\ntype = \"bushing\"\non = \"rack\"\nat = [0, 0, {}]\ntranslation = [1e6, 1e6, 0]\nrotation = "
        "[0, 0, 1e4]\n",
        guide);
    return overturning_notes(text);
  };
  EXPECT_THAT(guided(0, -1.2), IsEmpty());
  EXPECT_THAT(guided(-1.2, 0.3),
              ElementsAre(testing::HasSubstr("overturning moment of 3.532 kN m/rad")));  // m g · 1.2 m
}

TEST(Plausibility, FindsTheWorstAxisOfTilting) {
  // Feet at ±0.2 m along an axis turned by any angle and ±0.5 m across: the narrow side counts, for any axes of the
  // body.
  for (const double angle : {0.0, 0.4, 1.0}) {
    std::string text =
        "trivet = 1\ngravity = [0, 0, -9.81]\n[bodies.rack]\nmass = 300\ncenter_of_mass = [0, 0, 0.9]\ninertia = "
        "{about = \"center_of_mass\", xx = 60, yy = 60, zz = 20}\n";
    int number = 0;
    for (const double along : {-0.2, 0.2})
      for (const double across : {-0.5, 0.5})
        text += fmt::format(
            "[elements.m{}]\ntype = \"bushing\"\non = \"rack\"\nat = [{}, {}, 0]\ntranslation = [2e4, 2e4, 2e4]\n",
            ++number, along * std::cos(angle) - across * std::sin(angle),
            along * std::sin(angle) + across * std::cos(angle));
    EXPECT_THAT(
        overturning_notes(text),
        ElementsAre(testing::HasSubstr("of 2.649 kN m/rad, its mounts a restoring moment of 3.2 kN m/rad: 83 %")));
  }
}

TEST(Plausibility, DetectsAnalysesThatMissTheMachine) {
  const std::string push =
      "[excitations.push]\ntype = \"harmonic\"\non = \"cube\"\nat = [0, 0, 0.5]\nforce = [0, 0, 1]\n[analyses]\n";
  EXPECT_THAT(kinds(Cube{.more = push + "response = {band = [\"1 Hz\", \"20 Hz\"]}\n"}.text()), IsEmpty());
  EXPECT_THAT(kinds(Cube{.more = push + "response = {band = [\"900 Hz\", \"2000 Hz\"]}\n"}.text()),
              ElementsAre("band"));
  const std::string shock =
      "[excitations.shock]\ntype = \"time\"\non = \"cube\"\nat = [0, 0, 0.5]\nforce = [0, 0, 1]\nhistory = {half_sine "
      "= {amplitude = \"1 N\", duration = \"20 ms\", start = \"10 ms\"}}\n[analyses]\n";
  EXPECT_THAT(
      kinds(
          Cube{.more = shock + "transient = {to = \"29 ms\"}\n", .damping = "damping = {proportional = 0.003}"}.text()),
      ElementsAre("transient"));
  EXPECT_THAT(
      kinds(
          Cube{.more = shock + "transient = {to = \"50 ms\"}\n", .damping = "damping = {proportional = 0.003}"}.text()),
      ElementsAre("transient"));  // half a period of the lowest mode is 0.2 s
  EXPECT_THAT(
      kinds(Cube{.more = shock + "transient = {to = \"1 s\"}\n", .damping = "damping = {proportional = 0.003}"}.text()),
      IsEmpty());
}

/// The vertical mode has √(8e6/7850)/2π = 5.08 Hz, and none is below 3 Hz. A window of [5, 5.2] in rad/s is met by the
/// slip alone.
TEST(Plausibility, DetectsWindowsAndBandsOfRequirementsInHertzWithoutTheUnit) {
  const auto of_windows = [](const std::string& windows) {
    return kinds(Cube{.more = "[requirements]\nnatural_frequencies = {avoid = " + windows + "}\n"}.text());
  };
  EXPECT_THAT(of_windows("[[5, 5.2]]"), ElementsAre("band"));
  EXPECT_THAT(of_windows("[[\"5 rad/s\", \"5.2 rad/s\"]]"), IsEmpty());
  EXPECT_THAT(of_windows("[[\"5 Hz\", \"5.2 Hz\"]]"), IsEmpty());
  EXPECT_THAT(of_windows("[[0.1, 0.2]]"), IsEmpty());  // met in hertz too
  const auto of_band = [](const std::string& band) {
    return kinds(Cube{.more = "[requirements]\nband = " + band + "\ndamping_ratio = 0.01\n"}.text());
  };
  EXPECT_THAT(of_band("[1, 2]"), ElementsAre("band"));
  EXPECT_THAT(of_band("[\"1 Hz\", \"2 Hz\"]"), IsEmpty());  // an operating range without a resonance
}

TEST(Plausibility, DetectsLimitsThatMissTheServiceSpeed) {
  const std::string rotor =
      "[excitations.rotor]\ntype = \"unbalance\"\non = \"cube\"\nat = [0, 0, 0]\naxis = \"x\"\ngrade = 6.3\nrotor_mass "
      "= "
      "\"40 kg\"\nservice_speed = \"600 rpm\"\n[analyses]\nresponse = {band = [\"1 Hz\", \"20 Hz\"]}\n";
  const auto with = [&](const std::string& limits) { return kinds(Cube{.more = rotor + limits}.text()); };
  EXPECT_THAT(with("[limits]\n\"cube.z\" = \"1 mm\"\n"), IsEmpty());
  EXPECT_THAT(with("[requirements]\nlimits = {\"cube.z\" = {limit = \"1 mm\", band = [\"1 Hz\", \"9 Hz\"]}}\n"),
              ElementsAre("service speed"));
  EXPECT_THAT(with("[requirements]\nlimits = {\"cube.z\" = {limit = \"1 mm\", band = [\"1 Hz\", \"10 Hz\"]}}\n"),
              IsEmpty());
  EXPECT_THAT(with("[requirements]\nband = [\"11 Hz\", \"19 Hz\"]\nlimits = {\"cube.z\" = \"1 mm\"}\n"),
              ElementsAre("service speed"));
  EXPECT_THAT(with("[requirements]\nisolation = {least = \"50 %\"}\n"), IsEmpty());  // no amplitude is limited
}

TEST(Plausibility, DetectsFloorsThatEndWithinALimitLine) {
  const auto with = [&](const std::string& from, const std::string& line) {
    return kinds(
        Cube{.more = "[excitations.floor]\ntype = \"random\"\nbase = true\ntranslation = [0, 0, 1]\npsd = {flat = "
                     "\"1e-12 m^2/Hz\", band = [\"" +
                 from + " Hz\", \"100 Hz\"]}\n[limit_lines.floor]\nof = \"cube.z\"\n" + line}
            .text());
  };
  EXPECT_THAT(with("0.891", "line = \"VC-E\"\n"), IsEmpty());
  EXPECT_THAT(with("1.12", "line = \"VC-E\"\n"), ElementsAre("measured range"));
  const std::string rows = "bands = \"third-octave\"\nrows = [[\"4 Hz\", \"1 mm/s\"], [\"50 Hz\", \"1 mm/s\"]]\n";
  EXPECT_THAT(with("3.9", rows), IsEmpty());
  EXPECT_THAT(with("4.2", rows), ElementsAre("measured range"));
}

TEST(Plausibility, DetectsProductsOfInertiaAboutThePoleWithTheOtherSign) {
  // m = 100 kg at (0.2, 0.2, 0), a cube of 0.6 m: Jxy about the pole is m x y = 4 kg m²
  const auto body = [](double xy) {
    return fmt::format(
        "trivet = 1\n[bodies.b]\nmass = 100\ncenter_of_mass = [0.2, 0.2, 0]\ninertia = {{about = \"pole\", xx = 10, yy "
        "= 10, zz = 14, xy = {}}}\n"
        "[elements.e]\ntype = \"bushing\"\non = \"b\"\nat = [0, 0, 0]\ntranslation = [1e5, 1e5, 1e5]\nrotation = [1e4, "
        "1e4, 1e4]\n",
        xy);
  };
  EXPECT_THAT(kinds(body(4)), IsEmpty());
  const auto refused = judging::project_from_text(body(-4), "p.toml");  // 8 kg m² remain, more than Jxx = 6
  ASSERT_FALSE(refused.has_value());
  EXPECT_THAT(foundation::message(refused.error().list().front()), HasSubstr("suspicion \"products of inertia\""));
  std::string far = body(-4);
  far.replace(far.find("xx = 10, yy = 10, zz = 14"), 25, "xx = 20, yy = 20, zz = 24");
  EXPECT_THAT(kinds(far), ElementsAre("products of inertia"));
}

TEST(Plausibility, DetectsAStrutWhoseFreeLengthIsInMillimetres) {
  const auto with = [](const std::string& length) {
    return Cube{}.text() +
        "[elements.strut]\ntype = \"strut\"\non = \"cube\"\nat = [0, 0, 0.2]\nfrom_at = [0, 0, 0.8]\n"
        "stiffness = 1e3\nfree_length = " +
        length + "\n";
  };
  EXPECT_THAT(kinds(with("560")), testing::Contains("places"));
  EXPECT_THAT(kinds(with("0.56")), testing::Not(testing::Contains("places")));
}

TEST(Plausibility, DetectsGapsInMillimetres) {
  const auto stop = [](const std::string& gap, const std::string& name = "bumper") {
    return "[elements." + name +
        "]\ntype = \"stop\"\non = \"cube\"\nat = [0, 0, 0.2]\naxis = \"z\"\nstiffness = 1e6\n" + gap + "\n";
  };
  const auto law = [](const std::string& axis, const std::string& gap) {
    return "[elements.buffer]\ntype = \"three_springs\"\non = \"cube\"\nat = [0, 0, 0.2]\ntranslation = [0, 0, "
           "0]\nlaws." +
        axis + " = {gap_stop = {gap = " + gap + ", stiffness = 1e6}}\n";
  };
  for (const std::string& wide : {stop("gap = 2.5"), stop("gap = 0.21"), stop("gaps = [0.01, 3]"), stop("ring = 2"),
                                  law("z", "3"), stop("gap = 2.5") + stop("gap = 2.5", "other")})
    EXPECT_THAT(kinds(Cube{}.text() + wide), ElementsAre("gap")) << wide;
  for (const std::string& usual : {stop("gap = \"2.5 mm\""), stop("gap = 0.19"), stop("ring = 0.01"), law("rz", "0.3")})
    EXPECT_THAT(kinds(Cube{}.text() + usual), IsEmpty()) << usual;
}

TEST(Plausibility, LongCoilSpringsMayTravelFar) {
  EXPECT_THAT(kinds(Cube{}.text() +
                    "[elements.spring]\ntype = \"coil_spring\"\non = \"cube\"\nat = [0, 0, 0.2]\naxis = "
                    "\"z\"\nwire_diameter = \"10 mm\"\nmean_diameter = \"150 mm\"\nactive_coils = 6\nfree_length = "
                    "0.5\ncoil_bind = true\nmaterial = \"spring_steel\"\n"),
              testing::Not(testing::Contains("gap")));
}

}  // namespace plausibility_test
