// SPDX-License-Identifier: BSD-3-Clause
// Exact sensitivities of peaks against peaks of changed models.
#include <gmock/gmock.h>

#include <cmath>

#include "support/harmonic_question.h"
#include "support/matchers.h"
#include "support/projects.h"
#include "support/random_system.h"
#include "trivet/assembly/loads.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/modal/roots.h"
#include "trivet/project/model_number.h"
#include "trivet/response/sensitivity/peak_shares.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/peaks.h"
#include "trivet/study/explanation.h"

namespace explain_test {

using namespace trivet;
using test::drive;
using test::question;

response::Peaks peaks_of(const model::System& system, const response::Question& asked) {
  const assembly::Assembled assembled = assembly::assemble(system);
  const modal::Modes modes = modal::modes(system, assembled);
  return response::peaks(assembled, assembly::channels(system, assembled, asked.channels, asked.quantity),
                         asked.load(system, assembled), modes, modal::roots(system, assembled, modes));
}

/// ln height and ln frequency of the peak of this curve nearest to ω.
std::array<double, 2> nearest(const response::Peaks& peaks, std::size_t curve, double omega) {
  std::array<double, 2> best = {std::nan(""), std::nan("")};
  double distance = INFINITY;
  for (const response::Peak& peak : peaks.list)
    if (peak.curve == curve && std::abs(peak.angular_frequency - omega) < distance) {
      distance = std::abs(peak.angular_frequency - omega);
      best = {std::log(peak.amplitude), std::log(peak.angular_frequency)};
    }
  return best;
}

struct Comparison {
  double step = 2e-4;  ///< of the differences, relative or times a body's size
  double tolerance =
      2e-6;  ///< of the largest sensitivity of its kind: truncation (step/damping)⁴ and round-off of peaks over step
  int every = 1;  ///< compares every n-th parameter
};

/// Circles give peaks to 1e-10, so the differences need a longer step, which truncates more.
constexpr double step_by_circles = 2e-3, truncation_by_circles = 2e-5;

/// Compares every sensitivity of the most prominent peak of each curve with differences of the peaks of changed models.
/// Returns the number of comparisons.
int compare(const model::System& system, const response::Question& asked, const Comparison& how) {
  const assembly::Assembled assembled = assembly::assemble(system);
  const response::Peaks found = peaks_of(system, asked);
  std::vector<response::PeakPlace> places;
  for (std::size_t c = 0; c < asked.channels.size(); ++c) {
    const response::Peak* best = nullptr;
    for (const response::Peak& peak : found.list)
      if (peak.curve == c && (!best || peak.prominence > best->prominence)) best = &peak;
    if (best) places.push_back({c, best->angular_frequency, {}});
  }
  const response::SensitivityTable table = response::peak_sensitivities(system, assembled, asked, places);
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
    std::vector<std::array<double, 2>> difference(places.size(), {0, 0});
    for (const auto& [node, weight] :
         {std::pair{1.0, 8.0 / 12}, {-1.0, -8.0 / 12}, {2.0, -1.0 / 12}, {-2.0, 1.0 / 12}}) {
      const response::Peaks again = peaks_of(response::changed(system, parameter, node * step), asked);
      for (std::size_t i = 0; i < places.size(); ++i) {
        const auto logarithms = nearest(again, places[i].channel, places[i].angular_frequency);
        for (std::size_t k = 0; k < 2; ++k) difference[i][k] += weight / step * logarithms[k];
      }
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
      const response::Sensitivity& exact = table.peaks[i].list[p];
      const double size = parameter.size / 0.01;
      EXPECT_NEAR(*exact.height * size, difference[i][0] * size, how.tolerance * largest[i][0])
          << parameter.name << " on the height of " << asked.channels[places[i].channel];
      EXPECT_NEAR(*exact.frequency * size, difference[i][1] * size, how.tolerance * largest[i][1])
          << parameter.name << " on the frequency of " << asked.channels[places[i].channel];
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
                        question({"body 0.x", "body 0.tip.ry", "ground.force.z", "element 1.moment.x"},
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
    EXPECT_GT(compare(test::checked(description), question({"body 0.x", "element 0.force.y"}), {}), 20);
  }
}

TEST(PeakSensitivities, FollowRelaxingElementsWithInnerCoordinates) {
  for (const elements::Viscoelastic& law :
       {elements::Viscoelastic(elements::KelvinVoigt{1e-3}), elements::Viscoelastic(elements::Zener{0.8, 0.01}),
        elements::Viscoelastic(elements::GeneralizedMaxwell{{0.4, 0.3}, {0.02, 0.002}})}) {
    model::Description description = test::RandomSystem(12).description(1, test::RandomDamping::none);
    for (model::Element& element : description.elements) element.law.damping = law;
    EXPECT_GT(compare(test::checked(description), question({"body 0.y", "element 0.force.y"}), {.every = 3}), 20);
  }
}

TEST(PeakSensitivities, FollowElementsThatDependOnFrequency) {
  model::Description description = test::RandomSystem(13).description(1, test::RandomDamping::viscous);
  description.elements[0].law.damping = elements::FractionalZener{0.6, 0.01, 0.5};
  EXPECT_GT(compare(test::checked(description), question({"body 0.y", "element 0.force.y"}),
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
  EXPECT_GT(compare(with_mass.base().system, question({"machine.z", "machine.rx", "s1.force.z"}), {.every = 3}), 20);
  const auto preloaded =
      test::project(coil_machine("", "preload = {force = \"490.3325 N\"}\ndamping = {loss_factor = 0.05}\n"));
  EXPECT_GT(compare(preloaded.base().system, question({"machine.x", "machine.rx"}), {.every = 3}), 20);
}

/// Excitation of kind `kind`: the ground moves as one body, or by a wave along it, or a rotor has an unbalance.
TEST(PeakSensitivities, FollowAMovingGroundAndAnUnbalance) {
  for (int kind = 0; kind < 4; ++kind) {
    test::RandomSystem random(20 + static_cast<unsigned>(kind));
    model::Description description = random.description(2, test::RandomDamping::viscous);
    description.excitations = drive(kind, random);
    if (kind == 1) description.damping = model::RayleighDamping{0.4, 2e-4};
    if (kind == 0) description.elements[0].law.damping = elements::Zener{0.8, 0.01};
    EXPECT_GT(
        compare(test::checked(description),
                question({"body 0.x", "element 0.force.z", "ground.moment.x"}, assembly::MotionQuantity::velocity),
                {.every = 7}),
        20);
  }
}

TEST(PeakSensitivities, FollowAMovingGroundThroughElementsThatDependOnFrequency) {
  test::RandomSystem random(25);
  model::Description description = random.description(1, test::RandomDamping::viscous);
  description.excitations = drive(0, random);
  description.elements[0].law.damping = elements::FractionalZener{0.6, 0.01, 0.5};
  EXPECT_GT(compare(test::checked(description), question({"body 0.y", "element 0.force.y"}),
                    {.step = step_by_circles, .tolerance = truncation_by_circles, .every = 6}),
            10);
}

TEST(PeakSensitivities, ToAllDirectionsOfAnElementAreTogetherThatToItsStiffness) {
  using enum test::RandomDamping;
  constexpr double round_off = 1e-8;  // share of the largest: slopes of a resonance cancel
  for (const test::RandomDamping damping : {proportional, viscous, loss}) {
    const model::System system = test::checked(test::RandomSystem(16).description(2, damping));
    const auto asked = question({"body 0.x"});
    const response::Peaks found = peaks_of(system, asked);
    const auto table = response::peak_sensitivities(system, assembly::assemble(system), asked,
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

/// Bears its weight on hardening mounts, a stop, a gas spring along a line, and rubber whose stiffness depends on
/// frequency.
constexpr const char* nonlinear_machine = R"(trivet = 1
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
[elements.front]
type = "bushing"
on = "machine"
at = [0.4, 0.1, 0]
translation = [1e5, 1.2e5, 6e4]
rotation = [900, 800, 500]
damping = {loss_factor = 0.05}
laws.z = {cubic = 4e9, quadratic = 1e6}
[elements.rear]
type = "bushing"
on = "machine"
at = [-0.3, -0.2, 0.05]
translation = [1e5, 1.1e5, 5e4]
damping = {fractional_zener = {ratio = 0.3, time = "10 ms", order = 0.5}}
laws.z = {cubic = 6e9}
[elements.stop]
type = "stop"
on = "machine"
at = [-0.2, 0.3, 0]
axis = "-z"
gap = "1 mm"
stiffness = 3e6
power = 1.5
[elements.lift]
type = "strut"
on = "machine"
at = [0.1, -0.3, 0]
from_at = [0.1, -0.4, -0.3]
free_length = "340 mm"
stiffness = 3e4
coefficient = 150
[analyses]
response = {of = ["machine.z", "machine.rx", "front.force.z"], band = ["2 Hz", "30 Hz"]}
)";

TEST(PeakSensitivities, FollowThePositionOfRestOfANonlinearMachine) {
  const project::Project file = test::project(nonlinear_machine);
  const project::Case& base = file.base();
  const study::Explanation found = study::explanation(base, {{}, 3});
  ASSERT_EQ(found.peaks.size(), 3u);
  EXPECT_FALSE(found.notes.empty()) << "the tangents that were used";
  int compared = 0, moved = 0;
  for (const study::ExplainedPeak& peak : found.peaks) {
    for (std::size_t e = 0; e < base.system.elements().size(); ++e) {
      const auto& share = peak.shares.elements[e];
      EXPECT_NEAR(share.by_direction.sum(), share.stored, 1e-9) << base.system.elements()[e].name;
    }
    const response::Question asked = question({peak.name});
    double largest_height = 0, largest_frequency = 0;
    for (const response::Sensitivity& s : peak.sensitivities) {
      const double size = found.parameters[s.parameter].size / 0.01;
      largest_height = std::max(largest_height, std::abs(s.height.value()) * size);
      largest_frequency = std::max(largest_frequency, std::abs(s.frequency.value()) * size);
    }
    for (const response::Sensitivity& s : peak.sensitivities) {
      const response::Parameter& parameter = found.parameters[s.parameter];
      const project::ModelNumber number(parameter.name, "");
      const double before = number.read(base).value(), size = parameter.size / 0.01;
      const bool is_added = parameter.change != "+1 %";
      const double step = step_by_circles * (is_added ? 0.2 : 1);
      std::array<double, 2> difference = {0, 0};
      for (const auto& [node, weight] :
           {std::pair{1.0, 8.0 / 12}, {-1.0, -8.0 / 12}, {2.0, -1.0 / 12}, {-2.0, 1.0 / 12}}) {
        const double value = is_added ? before + node * step : before * (1 + node * step);
        const auto there = project::changed_system(base, {{number, value}});
        ASSERT_TRUE(there) << parameter.name;
        const auto logarithms = nearest(peaks_of(*there, asked), 0, peak.peak.angular_frequency);
        for (std::size_t k = 0; k < 2; ++k) difference[k] += weight / step * logarithms[k];
      }
      EXPECT_NEAR(*s.height * size, difference[0] * size, truncation_by_circles * largest_height)
          << parameter.name << " on the height of " << peak.name;
      EXPECT_NEAR(*s.frequency * size, difference[1] * size, truncation_by_circles * largest_frequency)
          << parameter.name << " on the frequency of " << peak.name;
      ++compared;
      // Without the new position of rest, more mass lowers every frequency; here it hardens the mounts.
      if (parameter.name == "bodies.machine.mass_about_center" && *s.frequency > -0.1) ++moved;
    }
  }
  EXPECT_GT(compared, 60);
  EXPECT_GT(moved, 0);
}

/// The stop closes exactly at rest: one side has another stiffness than the other.
TEST(PeakSensitivities, EndWhereAStopClosesAtRest) {
  const project::Project file = test::project(R"(trivet = 1
gravity = [0, 0, -10]
[bodies.m]
mass = 50
free = ["z"]
[elements.s]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [0, 0, 5e4]
damping = {translation = [0, 0, 50]}
[elements.stop]
type = "stop"
on = "m"
at = [0, 0, 0]
axis = "-z"
gap = "10.001 mm"
stiffness = 1e5
[excitations.f]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [0, 0, 1]
[analyses]
response = {of = ["m.z"], band = ["1 Hz", "30 Hz"]}
)");
  const study::Explanation found = study::explanation(file.base(), {{}, 1});
  ASSERT_EQ(found.peaks.size(), 1u);
  EXPECT_THAT(found.peaks[0].notes, testing::Contains(testing::HasSubstr("opens or closes a stop at rest")));
  EXPECT_EQ(std::count_if(found.peaks[0].notes.begin(), found.peaks[0].notes.end(),
                          [](const std::string& note) { return note.find("no slopes") != std::string::npos; }),
            1);
  for (const response::Sensitivity& s : found.peaks[0].sensitivities) {
    const std::string& name = found.parameters[s.parameter].name;
    EXPECT_EQ(s.height.has_value(), name.ends_with("damping_factor") || name.find("moved") != std::string::npos)
        << name;
  }
}

TEST(PeakSensitivities, UndampedPeakHasThoseOfItsMode) {
  const model::System system = test::checked(test::RandomSystem(14).description(2, test::RandomDamping::none));
  const assembly::Assembled assembled = assembly::assemble(system);
  const modal::Modes modes = modal::modes(system, assembled);
  const auto table = response::peak_sensitivities(system, assembled, question({"body 0.x"}),
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
  const auto table =
      response::peak_sensitivities(system, assembly::assemble(system), question({"body 0.x"}), {{0, 3.0, {}}});
  ASSERT_EQ(table.peaks[0].notes.size(), 1u);
  EXPECT_TRUE(table.peaks[0].list[0].height.has_value());
  EXPECT_FALSE(table.peaks[0].list[0].frequency.has_value());
  EXPECT_THROW(static_cast<void>(response::peak_sensitivities(system, assembly::assemble(system),
                                                              question({"body 0.x"}), {{0, 0.0, {}}})),
               foundation::InvalidInput);
}

}  // namespace explain_test
