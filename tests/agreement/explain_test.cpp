// SPDX-License-Identifier: BSD-3-Clause
// Exact sensitivities of peaks against peaks of changed models.
#include <gmock/gmock.h>

#include <cmath>

#include "support/matchers.h"
#include "support/peak_slopes.h"
#include "support/projects.h"
#include "support/random_system.h"
#include "support/sensitivity_request.h"
#include "trivet/assembly/loads.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/modal/roots.h"
#include "trivet/response/sensitivity/peak_shares.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/peaks.h"

namespace explain_test {

using namespace trivet;
using test::drive;
using test::peaks_of;
using test::PeakSlopes;
using test::sensitivity_request;
using test::step_by_circles;
using test::truncation_by_circles;

struct Comparison {
  double step = 2e-4;  ///< of the differences, relative or times a body's size
  double tolerance =
      2e-6;  ///< of the largest sensitivity of its kind: truncation (step/damping)⁴ and round-off of peaks over step
  int every = 1;  ///< compares every n-th parameter
};

/// Compares every sensitivity of the most prominent peak of each curve with differences of the peaks of changed models.
/// Returns the number of comparisons.
int compare(const model::System& system, const response::SensitivityRequest& request, const Comparison& how) {
  const assembly::Assembled assembled = assembly::assemble(system);
  const response::Peaks found = peaks_of(system, request);
  std::vector<response::PeakPlace> places;
  for (std::size_t c = 0; c < request.channels.size(); ++c) {
    const response::Peak* best = nullptr;
    for (const response::Peak& peak : found.list)
      if (peak.curve == c && (!best || peak.prominence > best->prominence)) best = &peak;
    if (best) places.push_back({c, best->angular_frequency, {}});
  }
  const response::SensitivityTable table = response::peak_sensitivities(system, assembled, request, places);
  std::vector<std::array<double, 2>> largest(places.size(), {0, 0});
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_THAT(table.peaks[i].notes, testing::IsEmpty());
    for (const response::Sensitivity& s : table.peaks[i].list) {
      const double size = table.parameters[s.parameter].size / 0.01;
      largest[i] = {std::max(largest[i][0], std::abs(s.height.value_or(0)) * size),
                    std::max(largest[i][1], std::abs(s.frequency.value_or(0)) * size)};
    }
  }
  int compared = 0;
  for (std::size_t p = 0; p < table.parameters.size(); p += to_size(how.every)) {
    const response::Parameter& parameter = table.parameters[p];
    const double step = how.step * (parameter.size == 0.01 ? 1 : 0.2);
    const std::vector<PeakSlopes> difference = test::peak_slopes(
        [&](double amount) { return response::changed(system, parameter, amount); }, step, request, places);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const response::Sensitivity& exact = table.peaks[i].list[p];
      const double size = parameter.size / 0.01;
      EXPECT_NEAR(*exact.height * size, difference[i].height * size, how.tolerance * largest[i][0])
          << parameter.name << " on the height of " << request.channels[places[i].channel];
      EXPECT_NEAR(*exact.frequency * size, difference[i].frequency * size, how.tolerance * largest[i][1])
          << parameter.name << " on the frequency of " << request.channels[places[i].channel];
      compared += 2;
    }
  }
  return compared;
}

TEST(PeakSensitivities, AreThoseOfPeaksSolvedAgain) {
  using enum test::RandomDamping;
  int compared = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const bool several = seed > 3;
    const model::System system = test::checked(
        test::RandomSystem(seed).description(several ? 3 : 1, std::array{proportional, viscous, loss}[seed % 3]));
    compared += compare(system,
                        sensitivity_request({"body 0.x", "body 0.tip.ry", "ground.force.z", "element 1.moment.x"},
                                            static_cast<assembly::MotionQuantity>(seed % 3)),
                        {.every = several ? 11 : 2});
  }
  EXPECT_GT(compared, 250);
}

TEST(PeakSensitivities, FollowDampingOfTheWholeSystem) {
  for (const model::SystemDamping& damping :
       {model::SystemDamping(model::RayleighDamping{0.4, 2e-4}), model::SystemDamping(model::ModalDamping{{0.03}}),
        model::SystemDamping(model::ModalDamping{{0.01, 0.02, 0.03, 0.04, 0.05, 0.06}})}) {
    model::Description description = test::RandomSystem(11).description(1, test::RandomDamping::none);
    description.damping = damping;
    EXPECT_GT(compare(test::checked(description), sensitivity_request({"body 0.x", "element 0.force.y"}), {}), 20);
  }
}

TEST(PeakSensitivities, FollowRelaxingElementsWithInnerCoordinates) {
  for (const elements::Viscoelastic& law :
       {elements::Viscoelastic(elements::KelvinVoigt{1e-3}), elements::Viscoelastic(elements::Zener{0.8, 0.01}),
        elements::Viscoelastic(elements::GeneralizedMaxwell{{0.4, 0.3}, {0.02, 0.002}})}) {
    model::Description description = test::RandomSystem(12).description(1, test::RandomDamping::none);
    for (model::Element& element : description.elements) element.law.damping = law;
    EXPECT_GT(compare(test::checked(description), sensitivity_request({"body 0.y", "element 0.force.y"}), {.every = 3}),
              20);
  }
}

TEST(PeakSensitivities, FollowElementsThatDependOnFrequency) {
  model::Description description = test::RandomSystem(13).description(1, test::RandomDamping::viscous);
  description.elements[0].law.damping = elements::FractionalZener{0.6, 0.01, 0.5};
  EXPECT_GT(compare(test::checked(description), sensitivity_request({"body 0.y", "element 0.force.y"}),
                    {.step = step_by_circles, .tolerance = truncation_by_circles, .every = 4}),
            10);
}

std::string coil_machine(const std::string& level, const std::string& more) {
  std::string text = R"(trivet = 1
gravity = [0, 0, -9.80665]
[bodies.machine]
mass = 200
center_of_mass = [0.02, -0.03, 0.2]
inertia = {about = "center_of_mass", xx = 9, yy = 12, zz = 14, xy = 0.5}
[excitations.f]
type = "harmonic"
on = "machine"
at = [0.1, 0.2, 0.3]
force = [10, 20, 50]
)";
  int number = 0;
  for (const char* at : {"[0.4, 0.3, 0]", "[0.4, -0.3, 0]", "[-0.4, 0.3, 0]", "[-0.4, -0.3, 0]"})
    text += "[elements.s" + std::to_string(++number) + "]\ntype = \"coil_spring\"\non = \"machine\"\nat = " + at +
        "\naxis = \"z\"\nwire_diameter = \"12 mm\"\nmean_diameter = \"90 mm\"\nactive_coils = 6\nfree_length = \"200 "
        "mm\"\nmaterial = "
        "\"spring_steel\"\n" +
        level + more;
  return text;
}

TEST(PeakSensitivities, FollowCoilSpringsWithMassAndWithPreload) {
  const auto with_mass = test::project(coil_machine("level = \"with_mass\"\n", "damping = {loss_factor = 0.05}\n"));
  EXPECT_GT(
      compare(with_mass.base().system, sensitivity_request({"machine.z", "machine.rx", "s1.force.z"}), {.every = 3}),
      20);
  const auto preloaded =
      test::project(coil_machine("", "preload = {force = \"490.3325 N\"}\ndamping = {loss_factor = 0.05}\n"));
  EXPECT_GT(compare(preloaded.base().system, sensitivity_request({"machine.x", "machine.rx"}), {.every = 3}), 20);
}

/// Excitation of kind `kind`: the ground moves as one body, or by a wave along it, or a rotor has an unbalance.
TEST(PeakSensitivities, FollowAMovingGroundAndAnUnbalance) {
  for (int kind = 0; kind < 4; ++kind) {
    test::RandomSystem random(20 + static_cast<unsigned>(kind));
    model::Description description = random.description(2, test::RandomDamping::viscous);
    description.excitations = drive(kind, random);
    if (kind == 1) description.damping = model::RayleighDamping{0.4, 2e-4};
    if (kind == 0) description.elements[0].law.damping = elements::Zener{0.8, 0.01};
    EXPECT_GT(compare(test::checked(description),
                      sensitivity_request({"body 0.x", "element 0.force.z", "ground.moment.x"},
                                          assembly::MotionQuantity::velocity),
                      {.every = 7}),
              20);
  }
}

TEST(PeakSensitivities, FollowAMovingGroundThroughElementsThatDependOnFrequency) {
  test::RandomSystem random(25);
  model::Description description = random.description(1, test::RandomDamping::viscous);
  description.excitations = drive(0, random);
  description.elements[0].law.damping = elements::FractionalZener{0.6, 0.01, 0.5};
  EXPECT_GT(compare(test::checked(description), sensitivity_request({"body 0.y", "element 0.force.y"}),
                    {.step = step_by_circles, .tolerance = truncation_by_circles, .every = 6}),
            10);
}

TEST(PeakSensitivities, ToAllDirectionsOfAnElementAreTogetherThatToItsStiffness) {
  using enum test::RandomDamping;
  constexpr double round_off = 1e-8;  // share of the largest: slopes of a resonance cancel
  for (const test::RandomDamping damping : {proportional, viscous, loss}) {
    const model::System system = test::checked(test::RandomSystem(16).description(2, damping));
    const auto request = sensitivity_request({"body 0.x"});
    const response::Peaks found = peaks_of(system, request);
    const auto table = response::peak_sensitivities(system, assembly::assemble(system), request,
                                                    {{0, found.list.at(0).angular_frequency, {}}});
    for (const model::Element& element : system.elements()) {
      double whole = 0, sum = 0, size = 0;
      for (const response::Sensitivity& s : table.peaks[0].list) {
        const std::string& name = table.parameters[s.parameter].name;
        if (name == "elements." + foundation::path_key(element.name) + ".scale") whole = *s.height;
        if (name.starts_with("elements." + foundation::path_key(element.name) + ".stiffness_factor."))
          sum += *s.height, size = std::max(size, std::abs(*s.height));
      }
      EXPECT_GT(size, 0);
      EXPECT_NEAR(sum, whole, round_off * std::max(size, 1.0)) << element.name;
    }
  }
}

TEST(ModelParameters, MoveAnElementWithoutChangingIt) {
  constexpr double round_off = 1e-14;  // m: a few rotations of numbers below 10
  const model::System system = test::checked(test::RandomSystem(17).description(3, test::RandomDamping::none));
  int moved = 0;
  for (const response::Parameter& parameter : response::model_parameters(system)) {
    if (parameter.name.find(".moved.") == std::string::npos) continue;
    const model::System other = response::changed(system, parameter, 0.2);
    for (std::size_t e = 0; e < system.elements().size(); ++e) {
      const model::Element &before = system.elements()[e], &after = other.elements()[e];
      const Eigen::Vector3d k = model::end_in_ground(other.bodies(), after.k).position -
          model::end_in_ground(system.bodies(), before.k).position;
      const Eigen::Vector3d n = model::end_in_ground(other.bodies(), after.n).position -
          model::end_in_ground(system.bodies(), before.n).position;
      EXPECT_LE((k - n).norm(), round_off);
      const bool own = parameter.name.starts_with("elements." + foundation::path_key(before.name) + ".");
      EXPECT_NEAR(k.norm(), own ? 0.2 : 0, round_off);
      moved += own;
    }
    EXPECT_EQ(other.warnings().list().size(), system.warnings().list().size()) << "it still resists no rigid motion";
  }
  EXPECT_EQ(moved, 18);
}

TEST(PeakSensitivities, UndampedPeakHasThoseOfItsMode) {
  const model::System system = test::checked(test::RandomSystem(14).description(2, test::RandomDamping::none));
  const assembly::Assembled assembled = assembly::assemble(system);
  const modal::Modes modes = modal::modes(system, assembled);
  const auto table = response::peak_sensitivities(system, assembled, sensitivity_request({"body 0.x"}),
                                                  {{0, *modes.list[2].angular_frequency, 3}});
  ASSERT_EQ(table.peaks[0].notes.size(), 1u) << "why there is no height";
  constexpr double step = 1e-4, truncation = 1e-6;  // of second order, and round-off of a mode over the step
  for (std::size_t p = 0; p < table.parameters.size(); ++p) {
    const response::Parameter& parameter = table.parameters[p];
    const auto logarithm = [&](double amount) {
      return std::log(*modal::modes(response::changed(system, parameter, amount)).list[2].angular_frequency);
    };
    EXPECT_FALSE(table.peaks[0].list[p].height.has_value());
    EXPECT_NEAR(*table.peaks[0].list[p].frequency, (logarithm(step) - logarithm(-step)) / (2 * step), truncation)
        << parameter.name;
  }
}

TEST(PeakSensitivities, ReportWhereThereIsNoMaximum) {
  const model::System system = test::checked(test::RandomSystem(15).description(1, test::RandomDamping::viscous));
  const auto table = response::peak_sensitivities(system, assembly::assemble(system), sensitivity_request({"body 0.x"}),
                                                  {{0, 3.0, {}}});
  ASSERT_EQ(table.peaks[0].notes.size(), 1u);
  EXPECT_TRUE(table.peaks[0].list[0].height.has_value());
  EXPECT_FALSE(table.peaks[0].list[0].frequency.has_value());
  EXPECT_THROW(static_cast<void>(response::peak_sensitivities(system, assembly::assemble(system),
                                                              sensitivity_request({"body 0.x"}), {{0, 0.0, {}}})),
               foundation::InvalidInput);
}

}  // namespace explain_test
