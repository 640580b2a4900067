// SPDX-License-Identifier: BSD-3-Clause
// Root mean squares in frequency bands against closed forms.
#include "trivet/response/random/random_bands.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/random_system.h"
#include "trivet/assembly/assembled.h"

namespace random_bands_test {

using namespace trivet;
using excitation::BandWidth;
using excitation::FrequencyBand;
using test::RelativelyNear;

constexpr double two_pi = 2 * std::numbers::pi;
constexpr double accuracy = 1e-9;  // of the closed form, whose logarithms and arcs cancel far below the resonance

constexpr double natural = two_pi * 9, damping_ratio = 0.03;

/// One mass of 1 kg along x under a force of density 1.
struct Oscillator {
  model::System system;
  assembly::Assembled assembled = assembly::assemble(system);

  static model::Description description(bool undamped) {
    model::Body body;
    body.name = "m";
    body.mass.mass = 1;
    body.has_inertia = false;
    body.free = {true, false, false, false, false, false};
    model::Element spring;
    spring.name = "spring";
    spring.type = "matrix";
    spring.k.body = 0;
    const auto along_x = [](double value) {
      return elements::constant_along_line(value, Eigen::Vector3d::UnitX(), Eigen::Vector3d::Zero(), 0);
    };
    spring.law.nominal_stiffness = along_x(natural * natural);
    if (!undamped) spring.law.damping = elements::DampingMatrix{along_x(2 * damping_ratio * natural)};
    model::Description d;
    d.bodies = {body};
    d.elements = {spring};
    return d;
  }

  response::RandomLoading white(double from, double to) const {
    model::Action action;
    action.body = 0;
    action.amplitude(0) = 1;
    return {{{"force", assembly::loading(assembled, action), excitation::flat_spectrum(1, from, to)}}, {}};
  }
  std::vector<assembly::Channel> channels(assembly::MotionQuantity quantity) const {
    return assembly::channels(system, assembled, {"m.x"}, quantity);
  }
};

/// ∫ r^(2 derivative) dr/((1 − r²)² + (2ζr)²) up to r, by partial fractions.
double integral(double r, int derivative) {
  const double q = std::sqrt(1 - damping_ratio * damping_ratio);
  const double logarithm = std::log((r * r + 2 * q * r + 1) / (r * r - 2 * q * r + 1)) / (8 * q);
  const double arcs = (std::atan((r + q) / damping_ratio) + std::atan((r - q) / damping_ratio)) / (4 * damping_ratio);
  return derivative == 0 ? arcs + logarithm : arcs - logarithm;
}

double closed_form(double from, double to, int derivative) {
  const double scale = std::pow(natural, 2 * derivative - 3);
  return std::sqrt(scale * (integral(to / natural, derivative) - integral(from / natural, derivative)));
}

TEST(RandomBands, AnOscillatorUnderWhiteNoiseHasTheClosedFormInEveryBand) {
  const Oscillator oscillator{test::checked(Oscillator::description(false))};
  for (const BandWidth width : {BandWidth::octave, BandWidth::third_octave}) {
    const auto bands = excitation::bands_between(width, two_pi * 3, two_pi * 60);
    const response::RandomLoading loading = oscillator.white(bands.front().from(), bands.back().to());
    for (const int derivative : {0, 1}) {
      const auto channels = oscillator.channels(derivative == 0 ? assembly::MotionQuantity::displacement
                                                                : assembly::MotionQuantity::velocity);
      const auto found = response::random_bands(oscillator.assembled, channels, loading, bands);
      double sum = 0;
      for (std::size_t b = 0; b < bands.size(); ++b) {
        EXPECT_THAT(found.rms[0][b], RelativelyNear(closed_form(bands[b].from(), bands[b].to(), derivative), accuracy))
            << bands[b].nominal_hz() << " Hz";
        sum += found.rms[0][b] * found.rms[0][b];
      }
      const auto total = response::random_response(oscillator.assembled, channels, loading);
      EXPECT_THAT(std::sqrt(sum), RelativelyNear(*total.channels[0].rms, accuracy));
    }
  }
}

TEST(RandomBands, ABandThatTheSpectrumDoesNotFillHasThePartOfIt) {
  const Oscillator oscillator{test::checked(Oscillator::description(false))};
  const FrequencyBand band{BandWidth::octave, 3};
  const double end = two_pi * 8.5;
  const auto found =
      response::random_bands(oscillator.assembled, oscillator.channels(assembly::MotionQuantity::velocity),
                             oscillator.white(two_pi, end), {band, {BandWidth::octave, 5}});
  EXPECT_THAT(found.rms[0][0], RelativelyNear(closed_form(band.from(), end, 1), accuracy));
  EXPECT_EQ(found.rms[0][1], 0);
}

TEST(RandomBands, OnlyTheBandOfAnUndampedResonanceIsInfinite) {
  const Oscillator oscillator{test::checked(Oscillator::description(true))};
  const auto bands = excitation::bands_between(BandWidth::third_octave, two_pi * 5.2, two_pi * 15);
  const auto found =
      response::random_bands(oscillator.assembled, oscillator.channels(assembly::MotionQuantity::velocity),
                             oscillator.white(two_pi, two_pi * 100), bands);
  for (std::size_t b = 0; b < bands.size(); ++b) {
    const bool resonant = natural > bands[b].from() && natural < bands[b].to();
    EXPECT_EQ(std::isinf(found.rms[0][b]), resonant) << bands[b].nominal_hz() << " Hz";
  }
}

}  // namespace random_bands_test
