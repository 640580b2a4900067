// SPDX-License-Identifier: BSD-3-Clause
// One mass on a spring and a dashpot on a ground given by its acceleration a: the motion relative to the ground is
// z = −a / (ω₀² − ω² + 2iζω₀ω).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/random_system.h"
#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/excitation/spectrum.h"
#include "trivet/foundation/index.h"
#include "trivet/response/random/random_response.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/peaks.h"
#include "trivet/response/transient/transient.h"

namespace relative_motion_test {

using namespace trivet;
using Complex = std::complex<double>;

constexpr double pi = std::numbers::pi;
constexpr double round_off = 1e-13;  // a handful of operations

struct Oscillator {
  double natural, ratio;
  model::System system;
  assembly::Assembled assembled;

  Oscillator(double omega, double damping_ratio)
      : natural(omega),
        ratio(damping_ratio),
        system(guided_mass_system(omega, damping_ratio)),
        assembled(assembly::assemble(system)) {}

  static model::System guided_mass_system(double omega, double damping_ratio) {
    constexpr double mass = 7.3;
    model::Description d;
    model::Body body;
    body.name = "m";
    body.mass.mass = mass;
    body.has_inertia = false;
    body.free = {false, false, true, false, false, false};
    body.pose.position = {0.4, -0.2, 1.1};
    d.bodies = {body};
    model::Element strut;
    strut.name = "strut";
    strut.type = "matrix";
    strut.n.at = body.pose.position;
    strut.k.body = 0;
    const auto along = [](double value) {
      return elements::constant_along_line(value, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero(), 0);
    };
    strut.law.nominal_stiffness = along(mass * omega * omega);
    strut.law.damping = elements::DampingMatrix{along(2 * damping_ratio * mass * omega)};
    d.elements = {strut};
    return test::checked(d);
  }

  [[nodiscard]] std::vector<assembly::Channel> channels(
      const std::vector<std::string>& of,
      assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement) const {
    return assembly::channels(system, assembled, of, quantity);
  }
  /// A motion of the ground along z, given by this derivative of its displacement.
  [[nodiscard]] assembly::Loading base(double amplitude, int derivative = 2) const {
    model::Action action;
    action.amplitude(2) = amplitude;
    action.derivative = derivative;
    return assembly::loading(assembled, action);
  }
  [[nodiscard]] Complex denominator(double omega) const {
    return {natural * natural - omega * omega, 2 * ratio * natural * omega};
  }
};

const std::vector<double> times_natural = {0, 1e-12, 1e-9, 1e-6, 1e-3, 0.5, 0.999, 3, 1e3, 1e6, 1e9};

TEST(RelativeMotion, MassOverAShakenGroundHasTheClosedFormFromRestToHighFrequency) {
  for (const double ratio : {0.01, 1.0, 30.0}) {
    const Oscillator o(23, ratio);
    const auto channels = o.channels({"m.relative.z", "strut.deflection.z", "strut.force.z", "m.z"});
    std::vector<double> omega = times_natural;
    for (double& w : omega) w *= o.natural;
    const auto found = response::frequency_response(o.assembled, channels, o.base(2), omega);
    const double stiffness = 7.3 * o.natural * o.natural, damping = 2 * ratio * 7.3 * o.natural;
    for (std::size_t i = 0; i < omega.size(); ++i) {
      const Complex z = -2.0 / o.denominator(omega[i]), force = -(stiffness + Complex(0, omega[i]) * damping) * z;
      const auto at = to_index(i);
      for (const std::size_t c : {0, 1})
        EXPECT_LE(std::abs(found.curves[c].value(at) - z), round_off * std::abs(z))
            << omega[i] << " rad/s, ratio " << ratio;
      EXPECT_LE(std::abs(std::abs(found.curves[2].value(at)) - std::abs(force)), round_off * std::abs(force))
          << omega[i] << " rad/s, ratio " << ratio;
      if (omega[i] == 0) {
        EXPECT_FALSE(std::isfinite(std::abs(found.curves[3].value(at))));  // in space it drifts with the ground
        continue;
      }
      const Complex in_space = -2 / (omega[i] * omega[i]) *
          Complex(o.natural * o.natural, 2 * ratio * o.natural * omega[i]) / o.denominator(omega[i]);
      EXPECT_LE(std::abs(found.curves[3].value(at) - in_space), round_off * std::abs(in_space))
          << omega[i] << " rad/s, ratio " << ratio;
    }
  }
}

TEST(RelativeMotion, HasTheStaticAmplitudeOfTheForceOfInertia) {
  const Oscillator o(23, 4);
  const modal::Modes modes = modal::modes(o.system, o.assembled);
  const response::Peaks peaks = response::peaks(o.assembled, o.channels({"m.relative.z"}), o.base(2), modes,
                                                modal::roots(o.system, o.assembled, modes));
  EXPECT_TRUE(peaks.list.empty());
  ASSERT_TRUE(peaks.curves[0].static_amplitude.has_value());
  constexpr double expected = 2 / (23.0 * 23), series_error = 1e-10;  // of a Taylor series on a disc
  EXPECT_NEAR(*peaks.curves[0].static_amplitude, expected, series_error * expected);
}

/// ∫ dω ω^(2 derivative) / |ω₀² − ω² + 2iζω₀ω|² by Gauss–Legendre of three points over many pieces of equal ratio.
double integral(const Oscillator& o, double from, double to, int derivative) {
  constexpr int pieces = 40000;
  constexpr double node = 0.7745966692414834, weights[] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
  const double step = std::log(to / from) / pieces;
  double sum = 0;
  for (int i = 0; i < pieces; ++i)
    for (int k = -1; k <= 1; ++k) {
      const double omega = from * std::exp((i + 0.5 * (1 + k * node)) * step);
      sum += 0.5 * step * weights[k + 1] * omega * std::pow(omega, 2 * derivative) / std::norm(o.denominator(omega));
    }
  return sum;
}

TEST(RandomRelativeMotion, HasRmsAndZeroCrossingsOfTheClosedFormFarBelowResonance) {
  constexpr double density = 0.3, accuracy = 1e-9;  // of the integral above
  for (const double ratio : {0.02, 5.0}) {
    const Oscillator o(40, ratio);
    for (const auto& [from, to] : {std::pair{1e-3, 1e3}, {1e-6, 1e-2}, {1e-8, 1e-5}}) {
      const response::RandomInput input{"base", o.base(1),
                                        excitation::flat_spectrum(density, from * o.natural, to * o.natural)};
      const response::RandomResponse found =
          response::random_response(o.assembled, o.channels({"m.relative.z", "strut.deflection.z"}), {{input}, {}});
      const double displacement = std::sqrt(density * integral(o, from * o.natural, to * o.natural, 0)),
                   velocity = std::sqrt(density * integral(o, from * o.natural, to * o.natural, 1));
      for (const response::RandomChannel& channel : found.channels) {
        ASSERT_TRUE(channel.rms && channel.zero_crossings) << channel.reason;
        EXPECT_NEAR(*channel.rms, displacement, accuracy * displacement) << from << " … " << to << ", ratio " << ratio;
        EXPECT_NEAR(*channel.zero_crossings, velocity / displacement / (2 * pi),
                    accuracy * velocity / displacement / (2 * pi))
            << from << " … " << to << ", ratio " << ratio;
      }
    }
  }
}

TEST(RandomRelativeMotion, AgreesWithMilesFromZeroOn) {
  const Oscillator o(40, 0.02);
  const double density = 0.3, miles = std::sqrt(pi * density / (4 * o.ratio * std::pow(o.natural, 3)));
  const response::RandomInput input{"base", o.base(1), excitation::flat_spectrum(density, 0, 1e3 * o.natural)};
  const response::RandomChannel channel =
      response::random_response(o.assembled, o.channels({"m.relative.z"}), {{input}, {}}).channels.at(0);
  ASSERT_TRUE(channel.rms && channel.zero_crossings) << channel.reason;
  constexpr double above_the_band = 1e-10;          // 4ζ/(3π) (ω₀/1e3 ω₀)³
  constexpr double velocity_above_the_band = 2e-5;  // 4ζ/π · 1e-3, of the square
  EXPECT_NEAR(*channel.rms, miles, above_the_band * miles);
  EXPECT_NEAR(*channel.zero_crossings, o.natural / (2 * pi), velocity_above_the_band * o.natural / (2 * pi));
}

TEST(TransientRelativeMotion, KeepsItsDigitsHoweverFarTheGroundDrifts) {
  const Oscillator o(11, 0.03);
  // Constant acceleration for 1e4 s: the ground ends 1e8 m away, and the mass is −a/ω₀² from its position on it.
  const excitation::Signal steady{{{0, 2, 0, 0, 0}}};
  response::TransientOptions options;
  options.from = 9'990;
  options.to = 10'000;
  options.step = 0.01;
  const auto found =
      response::transient_response(o.system, o.assembled, o.channels({"m.relative.z", "strut.deflection.z"}),
                                   {{"drift", steady, o.base(1)}}, options);
  const double rest = -2 / (o.natural * o.natural);  // after e^(−3,300)
  constexpr double stepped_round_off = 1e-11;        // 1e6 steps of an exponential near 1
  for (const response::TimeCurve& curve : found.curves)
    for (const double value : curve.values) ASSERT_NEAR(value, rest, stepped_round_off * std::abs(rest)) << curve.name;
}

}  // namespace relative_motion_test
