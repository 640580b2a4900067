// SPDX-License-Identifier: BSD-3-Clause
// Motions relative to a ground given by its acceleration, compared with the same machine on a ground at rest under the
// inertial forces.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string_view>

#include "support/shaken_machine.h"
#include "trivet/excitation/pulses_and_sweeps.h"
#include "trivet/foundation/index.h"
#include "trivet/response/random/random_response.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/visible_amplitudes.h"
#include "trivet/response/transient/transient.h"

namespace relative_coordinates_test {

using namespace trivet;
using Complex = std::complex<double>;

constexpr double round_off = 1e-9;       // up to 18 coordinates with condition up to 1e5
constexpr double of_variances = 1e-7;    // each of two variances is allowed an error of 1e-8
constexpr double extreme_height = 1e-8;  // of a flat extreme, found between two steps

/// Number of random machines of a test: few, or many with TRIVET_LONG_TESTS=1.
unsigned machines(unsigned few, unsigned many) {
  const char* request = std::getenv("TRIVET_LONG_TESTS");
  return request && std::string_view(request) == "1" ? many : few;
}

Eigen::Vector3cd shake(test::RandomSystem& draw) {
  return {std::polar(draw.number(0.1, 1), draw.number(-3, 3)), std::polar(draw.number(0.1, 1), draw.number(-3, 3)),
          std::polar(draw.number(0.1, 1), draw.number(-3, 3))};
}

void expect_same_peaks(const model::Description& machine, const Eigen::Vector3cd& acceleration, unsigned seed) {
  const test::ShakenAndPushed both(machine, acceleration);
  const test::Assembly shaken(both.shaken), pushed(both.pushed);
  const response::Peaks found = shaken.peaks(shaken.channels(both.relative)),
                        wanted = pushed.peaks(pushed.channels(both.plain));
  ASSERT_EQ(found.list.size(), wanted.list.size()) << "seed " << seed;
  for (std::size_t k = 0; k < found.list.size(); ++k) {
    const response::Peak &a = found.list[k], &b = wanted.list[k];
    EXPECT_EQ(a.curve, b.curve) << "seed " << seed;
    EXPECT_NEAR(a.amplitude, b.amplitude, round_off * b.amplitude) << "seed " << seed;
    EXPECT_NEAR(a.prominence, b.prominence, round_off * b.amplitude) << "seed " << seed;
    EXPECT_EQ(a.ratio_to_static.has_value(), b.ratio_to_static.has_value()) << "seed " << seed;
  }
  for (std::size_t c = 0; c < found.curves.size(); ++c) {
    ASSERT_TRUE(found.curves[c].static_amplitude.has_value()) << found.curves[c].name << ", seed " << seed;
    if (!wanted.curves[c].vanishes) {
      EXPECT_NEAR(*found.curves[c].static_amplitude, *wanted.curves[c].static_amplitude,
                  round_off * wanted.curves[c].highest)
          << found.curves[c].name << ", seed " << seed;
    }
  }
}

TEST(RelativeCoordinates, LightlyDampedMachinesHaveThePeaksOfForcesOfInertia) {
  for (unsigned seed = 1; seed <= machines(24, 3000); ++seed) {
    test::RandomSystem draw(seed);
    const model::Description machine = draw.description(1 + seed % 3, static_cast<test::RandomDamping>(1 + seed % 3));
    expect_same_peaks(machine, shake(draw), seed);
  }
}

TEST(RelativeCoordinates, OverdampedMachinesHaveThePeaksOfForcesOfInertia) {
  for (unsigned seed = 10001; seed <= 10000 + machines(12, 300); ++seed) {
    test::RandomSystem draw(seed);
    model::Description machine = draw.description(1 + seed % 3, test::RandomDamping::none);
    test::overdamp(machine, draw.number(1.1, 20));
    expect_same_peaks(machine, shake(draw), seed);
  }
}

TEST(RelativeCoordinates, GiveRandomResultsOfForcesOfInertia) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    test::RandomSystem draw(seed);
    const test::ShakenAndPushed both(draw.description(2, test::RandomDamping::viscous),
                                     shake(draw).real().cast<Complex>());
    const test::Assembly base(both.shaken), force(both.pushed);
    for (const auto& [from, to] : {std::pair{0.0, 500.0}, {1e-5, 1e-2}}) {
      const excitation::Spectrum flat = excitation::flat_spectrum(1, from, to);
      const auto found = response::random_response(base.assembled, base.channels(both.relative),
                                                   {{{"base", base.loading(), flat}}, {}})
                             .channels;
      const auto wanted = response::random_response(force.assembled, force.channels(both.plain),
                                                    {{{"force", force.loading(), flat}}, {}})
                              .channels;
      for (std::size_t c = 0; c < found.size(); ++c) {
        ASSERT_TRUE(found[c].rms && wanted[c].rms && found[c].zero_crossings && wanted[c].zero_crossings)
            << found[c].name << ": " << found[c].reason;
        EXPECT_NEAR(*found[c].rms, *wanted[c].rms, round_off * *wanted[c].rms)
            << found[c].name << ", seed " << seed << ", from " << from;
        EXPECT_NEAR(*found[c].zero_crossings, *wanted[c].zero_crossings, of_variances * *wanted[c].zero_crossings)
            << found[c].name << ", seed " << seed << ", from " << from;
      }
    }
  }
}

TEST(RelativeCoordinates, KeepTheDigitsOfADriftingRecord) {
  test::RandomSystem draw(4);
  const test::ShakenAndPushed both(draw.description(2, test::RandomDamping::viscous), Eigen::Vector3cd(0.3, -0.2, 1));
  const test::Assembly base(both.shaken), force(both.pushed);
  // Ten minutes at 2 m/s² (360 km), then a shock.
  excitation::Signal record{{{0, 2, 0, 0, 0}}};
  for (excitation::Piece piece : excitation::half_sine(50, 0.02, 600).pieces) {
    piece.value += 2;
    record.pieces.push_back(piece);
  }
  response::TransientOptions options;
  options.from = 599.9;
  options.to = 600.5;
  options.step = 0.01;
  const auto found = response::transient_response(base.system, base.assembled, base.channels(both.relative),
                                                  {{"record", record, base.loading()}}, options)
                         .curves;
  const auto wanted = response::transient_response(force.system, force.assembled, force.channels(both.plain),
                                                   {{"record", record, force.loading()}}, options)
                          .curves;
  for (std::size_t c = 0; c < found.size(); ++c) {
    const double scale = wanted[c].values.cwiseAbs().maxCoeff();
    EXPECT_LE((found[c].values - wanted[c].values).cwiseAbs().maxCoeff(), round_off * scale) << found[c].name;
    EXPECT_NEAR(found[c].largest.value, wanted[c].largest.value, extreme_height * scale) << found[c].name;
  }
}

TEST(RelativeCoordinates, CountGivenInitialStatesFromTheGroundThatMoves) {
  test::RandomSystem draw(6);
  const test::ShakenAndPushed both(draw.description(1, test::RandomDamping::viscous), Eigen::Vector3cd(0, 0, 1));
  const test::Assembly base(both.shaken);
  model::Action by_displacement = base.system.description().excitations[0].action;
  by_displacement.derivative = 0;
  response::TransientOptions options;
  options.from = 2;  // during the motion
  options.to = 4;
  options.step = 0.01;
  options.initial = response::initial_state(base.assembled, Eigen::VectorXd::LinSpaced(6, 0.1, 0.6),
                                            Eigen::VectorXd::LinSpaced(6, -3, 3));
  const auto channels = base.channels({"coordinates", "body 0.relative"});
  // The same motion of the ground as 0.4 m/s² and as the parabola 0.2 t².
  const auto found =
      response::transient_response(base.system, base.assembled, channels,
                                   {{"u", excitation::Signal{{{0, 0.4, 0, 0, 0}}}, base.loading()}}, options)
          .curves;
  const auto wanted =
      response::transient_response(
          base.system, base.assembled, channels,
          {{"u", excitation::Signal{{{0, 0, 0, 0.4, 0}}}, assembly::loading(base.assembled, by_displacement)}}, options)
          .curves;
  for (std::size_t c = 0; c < found.size(); ++c)
    EXPECT_LE((found[c].values - wanted[c].values).cwiseAbs().maxCoeff(),
              round_off * wanted[c].values.cwiseAbs().maxCoeff())
        << found[c].name;
}

/// Compares the results of the shaken machine with those of the pushed one at these ω.
void expect_same_response(const model::Description& machine, const std::vector<double>& omega) {
  const test::ShakenAndPushed both(machine, Eigen::Vector3cd(0.3, Complex(0, -0.2), 1));
  const test::Assembly base(both.shaken), force(both.pushed);
  const auto found =
      response::frequency_response(base.assembled, base.channels(both.relative), base.loading(), omega).curves;
  const auto wanted =
      response::frequency_response(force.assembled, force.channels(both.plain), force.loading(), omega).curves;
  for (std::size_t c = 0; c < found.size(); ++c)
    for (Eigen::Index i = 0; i < std::ssize(omega); ++i)
      EXPECT_LE(std::abs(found[c].value(i) - wanted[c].value(i)), round_off * wanted[c].value.cwiseAbs().maxCoeff())
          << found[c].name << " at " << omega[i];
}

const std::vector<double> from_rest_on = {0, 1e-9, 1e-4, 1, 30},
                          above_rest = {1e-9, 1e-4, 1, 30};  // [rad/s], up to the first resonances

TEST(RelativeCoordinates, HoldForInternalCoordinatesOfElements) {
  test::RandomSystem draw(11);
  model::Description machine = draw.description(2, test::RandomDamping::none);
  for (model::Element& element : machine.elements)
    element.law.damping = elements::Viscoelastic{elements::GeneralizedMaxwell{{0.7, 0.2}, {0.04, 0.5}}};
  expect_same_response(machine, from_rest_on);
}

TEST(RelativeCoordinates, HoldForElementsThatDependOnFrequency) {
  test::RandomSystem draw(12);
  model::Description machine = draw.description(2, test::RandomDamping::none);
  for (model::Element& element : machine.elements)
    element.law.damping = elements::Viscoelastic{elements::FractionalZener{0.7, 0.04, 0.5}};
  expect_same_response(machine, above_rest);
}

TEST(RelativeCoordinates, HoldForTheDampingOfTheSystemAsAWhole) {
  test::RandomSystem draw(13);
  model::Description machine = draw.description(2, test::RandomDamping::none);
  for (const model::SystemDamping& damping :
       {model::SystemDamping(model::RayleighDamping{0.3, 1e-4}), model::SystemDamping(model::ModalDamping{{0.02}})}) {
    machine.damping = damping;
    expect_same_response(machine, from_rest_on);
  }
}

/// Puts massless ground points under both feet that flex in `directions` and move with the ground in the others.
void put_on_impedances(model::Description& machine, const std::vector<int>& directions, test::RandomSystem& draw) {
  for (std::size_t e = 0; e < 2; ++e) {
    const auto count = to_index(directions.size());
    Eigen::Matrix<double, 6, Eigen::Dynamic> shape = Eigen::Matrix<double, 6, Eigen::Dynamic>::Zero(6, count);
    for (Eigen::Index i = 0; i < count; ++i) shape(directions[i], i) = 1;
    model::Element joint, &element = machine.elements[e];
    joint.name = element.name + ".foundation";
    joint.type = "foundation";
    joint.is_foundation = true;
    element.n.foundation = model::OnFoundation{machine.foundations.size(), shape,
                                               spatial::Matrix6::Identity() - shape * shape.transpose()};
    joint.n.at = joint.k.at = element.n.at;
    joint.k.foundation = element.n.foundation;
    joint.law.nominal_stiffness = elements::from_moved_end(draw.stiffness(5e4, 0.2), Eigen::Vector3d::Zero());
    joint.law.damping = elements::ProportionalDamping{1e-3, false};
    const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(count, count);
    machine.foundations.push_back({joint.name, none, none, none});
    machine.elements.push_back(joint);
  }
}

TEST(RelativeCoordinates, FollowTheGroundThroughFlexibleFoundations) {
  for (const std::vector<int>& directions : {std::vector<int>{2}, {0, 2, 4}, {0, 1, 2, 3, 4, 5}}) {
    test::RandomSystem draw(14);
    model::Description machine = draw.description(2, test::RandomDamping::viscous);
    put_on_impedances(machine, directions, draw);
    expect_same_response(machine, from_rest_on);
  }
}

TEST(RelativeCoordinates, HaveTheLimitOfElementsWithMass) {
  test::RandomSystem draw(15);
  model::Description machine = draw.description(1, test::RandomDamping::viscous);
  for (model::Element& element : machine.elements) {
    element.law.inertia = elements::Inertia{};
    element.law.inertia->mass = 1.5 * elements::Matrix12::Identity();
  }
  const test::ShakenAndPushed both(machine, Eigen::Vector3cd(1, 0, 0));
  const test::Assembly base(both.shaken);
  // Between ω = 0 and 0.01 rad/s everything changes by 2ζ 0.01/ω₀; at 0.01 rad/s the difference of motions in space is
  // still accurate.
  const auto found =
      response::frequency_response(base.assembled, base.channels(both.relative), base.loading(), {0, 0.01}).curves;
  const auto space =
      response::frequency_response(base.assembled, base.channels({"body 0"}), base.loading(), {0.01}).curves;
  constexpr double close_to_rest = 1e-3;  // 2ζ 0.01/ω₀, see above
  for (std::size_t j = 0; j < 6; ++j)
    EXPECT_LE(std::abs(found[j].value(0) - found[j].value(1)), close_to_rest * std::abs(found[j].value(1)))
        << found[j].name;
  const Eigen::VectorXd carried = base.system.bodies()[0].pose.rotation.transpose().col(0);
  for (Eigen::Index j = 0; j < 3; ++j) {
    const Complex wanted = space[j].value(0) + carried(j) / (0.01 * 0.01), was = found[j].value(1);
    EXPECT_LE(std::abs(was - wanted), round_off * carried.norm() / (0.01 * 0.01)) << found[j].name;
  }
}

TEST(RelativeCoordinates, FollowSupportsThatMoveTogether) {
  test::RandomSystem draw(16);
  const test::ShakenAndPushed both(draw.description(2, test::RandomDamping::viscous), Eigen::Vector3cd(0.3, -0.2, 1));
  model::Description supports = both.shaken;
  supports.excitations[0].action.elements = {0, 1};  // all elements on the ground
  const test::Assembly base(both.shaken), moved(supports);
  const std::vector<std::string> deflections(both.relative.begin() + 2, both.relative.end());
  const auto found =
      response::frequency_response(moved.assembled, moved.channels(deflections), moved.loading(), from_rest_on).curves;
  const auto wanted =
      response::frequency_response(base.assembled, base.channels(deflections), base.loading(), from_rest_on).curves;
  for (std::size_t c = 0; c < found.size(); ++c)
    EXPECT_LE((found[c].value - wanted[c].value).cwiseAbs().maxCoeff(),
              round_off * wanted[c].value.cwiseAbs().maxCoeff())
        << found[c].name;
}

TEST(RelativeCoordinates, DragGuidedBodiesAsAtRest) {
  // A skew spring moves the lower body, which can only move along z, relative to the ground, without bound towards
  // rest. The upper body moves with it.
  model::Description d;
  for (const char* name : {"low", "high"}) {
    model::Body body;
    body.name = name;
    body.mass.mass = 2;
    body.has_inertia = false;
    body.free = {false, false, true, false, false, false};
    d.bodies.push_back(body);
  }
  for (const std::size_t b : {0, 1}) {
    model::Element spring;
    spring.name = b == 0 ? "strut" : "neck";
    spring.type = "matrix";
    spring.k.body = b;
    if (b == 1) spring.n.body = 0;
    const Eigen::Vector3d axis = b == 0 ? Eigen::Vector3d(1, 0, 2).normalized() : Eigen::Vector3d::UnitZ();
    spring.law.nominal_stiffness = elements::constant_along_line(b == 0 ? 3000 : 800, axis, Eigen::Vector3d::Zero(), 0);
    spring.law.damping = elements::ProportionalDamping{0.01, false};
    d.elements.push_back(spring);
  }
  model::Excitation base{"base", {}, model::Harmonic{}};
  base.action.derivative = 2;
  base.action.amplitude(0) = 1;
  d.excitations = {base};
  const test::Assembly a(d);
  // z_low = x k_zx / k_zz = x/2 at rest; the upper mass is accelerated with it and stretches its spring by m z̈ / k.
  const double stretched = 2 * 0.5 / 800;
  constexpr double square_ratio = 1e-6;  // (ω/ω₀)² up to (1e-3 over 20 rad/s)², with room
  for (const double omega : {1e-8, 1e-5, 1e-3}) {
    const auto found =
        response::frequency_response(a.assembled, a.channels({"neck.deflection.z", "low.z"}), a.loading(), {omega})
            .curves;
    EXPECT_NEAR(std::abs(found[0].value(0)), stretched, square_ratio * stretched) << omega;
    EXPECT_NEAR(std::abs(found[1].value(0)) * omega * omega, 0.5, square_ratio) << omega;
  }
}

TEST(RelativeCoordinates, DoNotVanishAtRest) {
  test::RandomSystem draw(17);
  const test::ShakenAndPushed both(draw.description(2, test::RandomDamping::viscous), Eigen::Vector3cd(0.3, -0.2, 1));
  const test::Assembly base(both.shaken);
  const modal::Roots roots = modal::roots(base.system, base.assembled, modal::modes(base.system, base.assembled));
  for (const bool vanishes :
       response::vanish_at_both_ends(base.assembled, base.channels(both.relative), base.loading(), roots))
    EXPECT_FALSE(vanishes);
}

}  // namespace relative_coordinates_test
