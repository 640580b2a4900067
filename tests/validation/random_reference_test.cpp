// SPDX-License-Identifier: BSD-3-Clause
// Random vibration against published formulas, tables and closed forms.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/random_system.h"
#include "trivet/assembly/assembled.h"
#include "trivet/excitation/spectrum.h"
#include "trivet/response/random/random_response.h"

namespace random_reference_test {

using namespace trivet;

constexpr double pi = std::numbers::pi;
constexpr double g = 9.80665;  // m/s²

model::Body mass(const std::string& name, double kilograms, double height = 0) {
  model::Body body;
  body.name = name;
  body.mass.mass = kilograms;
  body.has_inertia = false;
  body.free = {false, false, true, false, false, false};
  body.pose.position.z() = height;
  return body;
}

/// A vertical spring and dashpot of zero length from the ground or a body to a body above.
model::Element strut(const std::string& name, std::optional<std::size_t> from, std::size_t on, double stiffness,
                     double damping, double height = 0) {
  model::Element element;
  element.name = name;
  element.type = "matrix";
  element.n.body = from;
  element.n.at.z() = from ? 0 : height;
  element.k.body = on;
  element.law.nominal_stiffness =
      elements::constant_along_line(stiffness, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero(), 0);
  if (damping > 0)
    element.law.damping = elements::DampingMatrix{
        elements::constant_along_line(damping, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero(), 0)};
  return element;
}

struct Case {
  model::System system;
  assembly::Assembled assembled = assembly::assemble(system);
  response::RandomChannel result(const std::string& of, assembly::MotionQuantity quantity,
                                 const response::RandomInput& input,
                                 const response::RandomOptions& options = {}) const {
    const auto channels = assembly::channels(system, assembled, {of}, quantity);
    return response::random_response(assembled, channels, {{input}, {}}, options).channels.at(0);
  }
  assembly::Loading base(int derivative) const {
    model::Action action;
    action.amplitude(2) = 1;
    action.derivative = derivative;
    return assembly::loading(assembled, action);
  }
  assembly::Loading force(std::size_t body, double newtons) const {
    model::Action action;
    action.body = body;
    action.amplitude(2) = newtons;
    return assembly::loading(assembled, action);
  }
};

Case oscillator(double kilograms, double omega, double damping_ratio) {
  model::Description d;
  d.bodies = {mass("m", kilograms)};
  d.elements = {strut("spring", std::nullopt, 0, kilograms * omega * omega, 2 * damping_ratio * kilograms * omega)};
  return {test::checked(d)};
}

excitation::Spectrum flat_hz(double density_per_hz, double from_hz, double to_hz) {
  return excitation::flat_spectrum(density_per_hz / (2 * pi), 2 * pi * from_hz, 2 * pi * to_hz);
}

TEST(MilesEquation, AgreesWithTheFormulaAndItsExactNeighbours) {
  // Miles, Journal of the Aeronautical Sciences 21 (1954) 753–762: f_n = 80 Hz, Q = 10, 0.04 g²/Hz.
  constexpr double integral_error = 1e-6;  // of separate integrals; white noise ends at 0.8 GHz here
  constexpr double last_digit = 1e-15;     // one multiplication
  const Case c = oscillator(2.5, 2 * pi * 80, 0.05);
  const response::RandomInput wide{"shaker", c.base(2), flat_hz(0.04 * g * g, 0, 8e8)},
      narrow{"shaker", c.base(2), flat_hz(0.04 * g * g, 20, 2000)};
  const response::RandomChannel relative = c.result("m.relative.z", assembly::MotionQuantity::displacement, wide);
  EXPECT_NEAR(*relative.rms / 0.0002751793829982445, 1, integral_error);
  EXPECT_NEAR(*relative.rms * std::pow(2 * pi * 80, 2) / g / 7.0898154036220635, 1, integral_error);
  EXPECT_NEAR(*relative.zero_crossings / 80, 1, integral_error);  // white noise: the undamped natural frequency
  EXPECT_NEAR(*relative.three_sigma / *relative.rms, 3, last_digit);
  EXPECT_NEAR(*c.result("m.z", assembly::MotionQuantity::acceleration, wide).rms / g / 7.125176298310874, 1,
              integral_error);
  EXPECT_NEAR(*c.result("m.z", assembly::MotionQuantity::acceleration, narrow).rms / g / 7.066220704474251, 1,
              integral_error);
}

TEST(RandomBaseAcceleration, DensitiesAreThoseOfCodeAster) {
  // code_aster test sdld101a: 100 kg on 1e6 N/m, 5 % of critical, unit density per hertz of the ground's acceleration.
  constexpr double published_digits = 1e-3, all_digits = 1e-10;  // the published ones have small errors of their own
  struct Row {
    double f, absolute_published, absolute, relative_published, relative;
  };
  constexpr Row rows[] = {{5, 1.2307, 1.2307179681278728, 0.011976, 0.011976491536097618},
                          {10, 2.7116, 2.7116573463372973, 0.42096, 0.42096223140711075},
                          {15, 47.2154, 47.21577894978052, 36.9225, 36.92589392202976},
                          {20, 2.8924, 2.89242112158763, 7.1006, 7.100623129870979},
                          {25, 0.47047, 0.47047853061314016, 2.7953, 2.7953332917309908}};
  const Case c = oscillator(100, 100, 0.05);
  auto channels =
      assembly::channels(c.system, c.assembled, {"m.z", "m.relative.z"}, assembly::MotionQuantity::acceleration);
  for (const Row& row : rows) {
    const auto curves = response::random_curves(c.assembled, channels,
                                                {{{"ground", c.base(2), flat_hz(1, 1, 100)}}, {}}, {2 * pi * row.f});
    const double absolute = 2 * pi * curves.density[0][0], relative = 2 * pi * curves.density[1][0];
    EXPECT_NEAR(absolute / row.absolute, 1, all_digits);
    EXPECT_NEAR(absolute / row.absolute_published, 1, published_digits);
    EXPECT_NEAR(relative / row.relative, 1, all_digits);
    EXPECT_NEAR(relative / row.relative_published, 1, published_digits);
  }
}

/// The quarter car by hand: sprung m_s on k_s, c_s above unsprung m_u on the tyre k_t; the road moves by 1 e^{iωt}.
struct QuarterCar {
  double sprung = 300, unsprung = 40, suspension = 18000, damper = 1200, tyre = 180000;

  std::pair<std::complex<double>, std::complex<double>> heights(double omega) const {
    const std::complex<double> joint(suspension, omega * damper);
    const std::complex<double> a = joint - omega * omega * sprung, d = joint + tyre - omega * omega * unsprung;
    const std::complex<double> wheel = tyre * a / (a * d - joint * joint);
    return {joint / a * wheel, wheel};
  }
};

TEST(RandomRoad, AQuarterCarOnAClassCRoadAgreesWithItsIntegralByHand) {
  // ISO 8608 class C (geometric mean 256e-6 m³) at 20 m/s.
  constexpr double truncation = 1e-8;  // Simpson's rule over log ω, 40,000 steps
  const QuarterCar car;
  model::Description description;
  description.bodies = {mass("wheel", car.unsprung), mass("car", car.sprung)};
  description.elements = {strut("tyre", std::nullopt, 0, car.tyre, 0),
                          strut("suspension", 0, 1, car.suspension, car.damper)};
  const Case c{test::checked(description)};
  const excitation::Spectrum road = excitation::road_spectrum(excitation::road_class('C'), 20);
  // Independent of the floor `excitation`: S(ω) = G(n₀) (n₀ v)² 2π / (v ω²) … with n = ω/(2πv), S(ω) dω = G(n) dn.
  const auto density = [](double omega) { return 256e-6 * std::pow(omega / (2 * pi * 20 * 0.1), -2) / (2 * pi * 20); };
  double acceleration = 0, travel = 0, travel_rate = 0, tyre_force = 0;
  constexpr int steps = 40000;
  const double from = std::log(2 * pi * 20 * 0.011), to = std::log(2 * pi * 20 * 2.83);
  for (int i = 0; i <= steps; ++i) {
    const double omega = std::exp(from + (to - from) * i / steps);
    const double weight = (to - from) / steps / 3 *
        (i == 0 || i == steps ? 1
             : i % 2 == 1     ? 4
                              : 2) *
        omega * density(omega);
    const auto [body, wheel] = car.heights(omega);
    acceleration += weight * std::pow(omega, 4) * std::norm(body);
    travel += weight * std::norm(body - wheel);
    travel_rate += weight * omega * omega * std::norm(body - wheel);
    tyre_force += weight * std::norm(car.tyre * (wheel - 1.0));
  }
  const response::RandomInput input{"road", c.base(0), road};
  EXPECT_NEAR(*c.result("car.z", assembly::MotionQuantity::acceleration, input).rms / std::sqrt(acceleration), 1,
              truncation);
  const response::RandomChannel rattle =
      c.result("suspension.deflection.z", assembly::MotionQuantity::displacement, input);
  EXPECT_NEAR(*rattle.rms / std::sqrt(travel), 1, truncation);
  EXPECT_NEAR(*rattle.zero_crossings / (std::sqrt(travel_rate / travel) / (2 * pi)), 1, truncation);
  EXPECT_NEAR(*c.result("tyre.force.z", assembly::MotionQuantity::displacement, input).rms / std::sqrt(tyre_force), 1,
              truncation);
}

TEST(HumanWeighting, AVeryNarrowBandHasThePublishedFactors) {
  // ISO 2631-1 annex B / ISO 8041-1 at 15.915 Hz: Wk 0.7718, Wd 0.1261. The acceleration of a free mass is F/m.
  constexpr double printed_digits = 0.00005 / 0.1261;
  model::Description description;
  description.bodies = {mass("seat", 2)};
  const Case c{test::checked(description)};
  const response::RandomInput input{"force", c.force(0, 2), flat_hz(1, 15.91499, 15.91501)};
  using excitation::Weighting;
  for (const auto& [weighting, factor] : {std::pair{Weighting::Wk, 0.7718}, {Weighting::Wd, 0.1261}})
    for (const auto quantity : {assembly::MotionQuantity::displacement, assembly::MotionQuantity::acceleration}) {
      const response::RandomChannel result = c.result("seat.z", quantity, input, {.weighted = {{0, weighting}}});
      EXPECT_NEAR(*result.weighted_rms / (factor * std::sqrt(2e-5)), 1, printed_digits);
    }
}

TEST(HumanWeighting, AWideBandAgreesWithTheSumOverItsCurve) {
  constexpr double truncation = 1e-8;  // Simpson's rule, 100,000 steps
  const Case c = oscillator(80, 2 * pi * 3, 0.2);
  const response::RandomInput input{"floor", c.base(2), flat_hz(0.01, 0, 80)};
  double sum = 0;
  constexpr int steps = 100000;
  const double h = 2 * pi * 80 / steps, w0 = 2 * pi * 3;
  for (int i = 0; i <= steps; ++i) {
    const double omega = h * i;
    const std::complex<double> joint(w0 * w0, 2 * 0.2 * w0 * omega);
    sum += h / 3 *
        (i == 0 || i == steps ? 1
             : i % 2 == 1     ? 4
                              : 2) *
        0.01 / (2 * pi) * std::norm(joint / (joint - omega * omega)) *
        std::norm(excitation::transfer(excitation::Weighting::Wk, omega));
  }
  const response::RandomChannel result =
      c.result("m.z", assembly::MotionQuantity::velocity, input, {.weighted = {{0, excitation::Weighting::Wk}}});
  EXPECT_FALSE(result.rms);  // a flat acceleration down to 0 Hz has no finite velocity …
  EXPECT_THAT(result.reason, testing::HasSubstr("begins at 0 Hz"));
  ASSERT_TRUE(result.weighted_rms);  // … but the weighting removes it
  EXPECT_NEAR(*result.weighted_rms / std::sqrt(sum), 1, truncation);
}

TEST(CriticalDamping, ADoublePoleIsIntegratedWithoutPoles) {
  // ∫₀^∞ S/(m²(ω² + ω₀²)²) dω = π S/(4 m² ω₀³).
  constexpr double settled = 1e-7;  // the quadrature ends at 1e-8 of the variance
  const Case c = oscillator(1, 10, 1);
  const auto channels = assembly::channels(c.system, c.assembled, {"m.z"}, assembly::MotionQuantity::displacement);
  const auto random = response::random_response(c.assembled, channels,
                                                {{{"force", c.force(0, 1), excitation::flat_spectrum(1, 0, 1e5)}}, {}});
  EXPECT_EQ(random.method, response::RandomMethod::quadrature);
  EXPECT_FALSE(random.remark.empty());
  EXPECT_NEAR(*random.channels[0].rms / std::sqrt(pi / 4e3), 1, settled);
}

TEST(InfiniteVariance, IsAMissingNumberWithItsReason) {
  const Case undamped = oscillator(1, 10, 0), damped = oscillator(1, 10, 0.1);
  const response::RandomChannel resonance =
      undamped.result("m.z", assembly::MotionQuantity::displacement,
                      {"force", undamped.force(0, 1), excitation::flat_spectrum(1, 1, 100)});
  EXPECT_FALSE(resonance.rms || resonance.rms_of_derivative || resonance.zero_crossings || resonance.three_sigma);
  EXPECT_THAT(resonance.reason, testing::HasSubstr("undamped natural frequency"));
  // A band below resonance has a finite variance also without damping: ∫₁⁵ dω/(100 − ω²)².
  const auto primitive = [](double w) { return w / (200 * (100 - w * w)) + std::log((10 + w) / (10 - w)) / 4000; };
  const response::RandomChannel below =
      undamped.result("m.z", assembly::MotionQuantity::displacement,
                      {"force", undamped.force(0, 1), excitation::flat_spectrum(1, 1, 5)});
  constexpr double round_off = 1e-12;  // of a difference of two closed forms
  EXPECT_NEAR(*below.rms, std::sqrt(primitive(5) - primitive(1)), round_off);
  const response::RandomInput floor{"floor", damped.base(2), excitation::flat_spectrum(1, 0, 100)};
  EXPECT_FALSE(damped.result("m.z", assembly::MotionQuantity::displacement, floor).rms);
  EXPECT_TRUE(damped.result("m.relative.z", assembly::MotionQuantity::displacement, floor).rms);
  EXPECT_TRUE(damped.result("m.z", assembly::MotionQuantity::acceleration, floor).rms);
}

}  // namespace random_reference_test
