// SPDX-License-Identifier: BSD-3-Clause
// Slider crank and gas torque against the textbook series (Taylor; Den Hartog, chapter 5), the exact kinematics,
// Fourier integrals and the work of the cycle.
#include "trivet/excitation/slider_crank.h"

#include <gmock/gmock.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "support/matchers.h"
#include "trivet/excitation/engine_orders.h"
#include "trivet/foundation/invalid_input.h"

namespace slider_crank_test {

using namespace trivet;
using namespace trivet::excitation;
using Complex = std::complex<double>;
using test::RelativelyNear;
using ::testing::HasSubstr;

constexpr double pi = std::numbers::pi;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double round_off = 1e-12;  // sums of up to some hundred terms

TEST(SliderCrank, HasTheSeriesOfTheTextbooks) {
  constexpr double l = 0.3;
  const std::vector<double> a = inertia_coefficients(l, 8), g = inertia_torque_coefficients(l, 4);
  EXPECT_EQ(a[1], 1);
  EXPECT_EQ(a[3], 0);
  // The series is truncated after λ⁷: the next term is below λ⁹, 2 λ⁹ and 3 λ⁹.
  EXPECT_NEAR(a[2], l + std::pow(l, 3) / 4 + 15 * std::pow(l, 5) / 128 + 35 * std::pow(l, 7) / 512, std::pow(l, 9));
  EXPECT_NEAR(a[4], -(std::pow(l, 3) / 4 + 3 * std::pow(l, 5) / 16 + 35 * std::pow(l, 7) / 256), 2 * std::pow(l, 9));
  EXPECT_NEAR(a[6], 9 * std::pow(l, 5) / 128 + 45 * std::pow(l, 7) / 512, 3 * std::pow(l, 9));
  // Torque: −(¼λ sin φ − ½ sin 2φ − ¾λ sin 3φ − ¼λ² sin 4φ), leading terms.
  EXPECT_NEAR(g[1], -l / 4, std::pow(l, 3));
  EXPECT_NEAR(g[2], 0.5, std::pow(l, 4));
  EXPECT_NEAR(g[3], 0.75 * l, std::pow(l, 3));
  EXPECT_NEAR(g[4], l * l / 4, std::pow(l, 4));
}

TEST(SliderCrank, CoefficientsAreThoseOfTheExactKinematics) {
  // Reference for λ = 0.3 by discrete Fourier transform of the exact motion, all digits.
  constexpr double all_digits = 1e-10, sixth_order = 1e-8;  // of a coefficient of 2e-4: round-off of numbers near 1
  const std::vector<double> a = inertia_coefficients(0.3, 6);
  EXPECT_THAT(a[2], RelativelyNear(0.3070506590621658, all_digits));
  EXPECT_THAT(a[4], RelativelyNear(-0.007237694996822019, all_digits));
  EXPECT_THAT(a[6], RelativelyNear(0.00019193674663644267, sixth_order));
  for (const double l : {0.05, 0.3, 0.6, 0.9}) {  // here the sums must equal the motion
    const int count = negligible_order(l);
    const std::vector<double> all = inertia_coefficients(l, count), torque = inertia_torque_coefficients(l, 2 * count);
    for (const double phi : {0.0, 0.4, 1.3, 2.9, 4.4}) {
      const double sine = std::sin(phi), cosine = std::cos(phi), root = std::sqrt(1 - l * l * sine * sine);
      const double first = -sine - l * sine * cosine / root;  // s′/r, s″/r
      const double second = -cosine - l * (cosine * cosine - sine * sine) / root -
          l * l * l * std::pow(sine * cosine, 2) / std::pow(root, 3);
      double inertia = 0, product = 0;
      for (int n = 0; n <= count; ++n) inertia += all[n] * std::cos(n * phi);
      for (int n = 0; n <= 2 * count; ++n) product += torque[n] * std::sin(n * phi);
      EXPECT_NEAR(-inertia, second, round_off);
      EXPECT_NEAR(product, first * second, round_off);
    }
  }
  EXPECT_THROW((void)inertia_coefficients(1, 4), foundation::InvalidInput);
  EXPECT_THROW((void)inertia_coefficients(0, 4), foundation::InvalidInput);
  EXPECT_THROW((void)inertia_coefficients(0.3, 0), foundation::InvalidInput);
}

/// One cylinder that stands upright, its crank at top dead centre.
Engine one_cylinder() {
  Engine engine{.crank_radius = 0.045, .rod_ratio = 0.3, .oscillating_mass = 0.55};
  engine.cylinders = {{.position = 0, .bank_angle = 0, .crank_angle = 0}};
  return engine;
}

/// A synthetic pressure: polytropic compression and expansion with combustion, over 720°, start of the cycle at firing
/// top dead centre.
PressureTrace made_trace(const Engine& engine, int points) {
  PressureTrace trace;
  for (int i = 0; i < points; ++i) {
    const double phi = 4 * pi * i / points, sine = std::sin(phi);
    const double stroke = 1 - std::cos(phi) +
        (1 - std::sqrt(1 - std::pow(engine.rod_ratio * sine, 2))) / engine.rod_ratio;  // of r, from the top
    const double volume = 1 + 4.5 * stroke, closed = phi < 0.9 * pi || phi > 3.1 * pi ? 1 : 0;
    const double burnt = phi < 0.9 * pi ? 1 - std::exp(-3 * phi) : 0;
    trace.angles.push_back(phi);
    trace.pressures.push_back(closed * (2e6 + 4e6 * burnt) * std::pow(volume, -1.3) - 1e4 * (1 - closed));
  }
  return trace;
}

TEST(GasTorque, HarmonicsAreTheFourierIntegralsOfPressureTimesLever) {
  const Engine engine = one_cylinder();
  const PressureTrace trace = made_trace(engine, 90);
  constexpr double bore = 0.08;
  const std::vector<TorqueHarmonic> harmonics = gas_harmonics(trace, engine, bore, 6);
  ASSERT_EQ(harmonics.size(), 13u);
  const double area = pi * bore * bore / 4, scale = area * engine.crank_radius * 6e6;
  for (const TorqueHarmonic& harmonic : harmonics) {
    Complex sum = 0;
    constexpr int per_line = 400;               // Simpson within each straight line
    constexpr double quadrature_error = 1e-11;  // of steps of 0.02°, 36,000 terms
    for (std::size_t i = 0; i < trace.angles.size(); ++i) {
      const double a = trace.angles[i], b = a + 4 * pi / 90, p = trace.pressures[i], q = trace.pressures[(i + 1) % 90];
      for (int k = 0; k <= per_line; ++k) {
        const double share = static_cast<double>(k) / per_line, phi = a + share * (b - a), sine = std::sin(phi);
        const double lever =
            sine + engine.rod_ratio * sine * std::cos(phi) / std::sqrt(1 - std::pow(engine.rod_ratio * sine, 2));
        const double weight = (k == 0 || k == per_line ? 1 : k % 2 ? 4 : 2) / 3.0 * (b - a) / per_line;
        sum += weight * area * (p + share * (q - p)) * engine.crank_radius * lever *
            std::polar(1.0, -harmonic.order * phi);
      }
    }
    sum /= harmonic.order == 0 ? 4 * pi : 2 * pi;
    EXPECT_LE(std::abs(harmonic.torque - sum), quadrature_error * scale) << harmonic.order;
  }
  EXPECT_GT(harmonics[0].torque.real(), 0);  // the gas drives
}

TEST(GasTorque, MeanIsTheWorkOfTheCycle) {
  // Mean torque · 4π = ∮ p dV, with the swept volume A(s(0) − s(φ)): indicator work by separate trapezoids.
  const Engine engine = one_cylinder();
  const PressureTrace trace = made_trace(engine, 7200);
  const double area = pi * 0.08 * 0.08 / 4;
  const auto volume = [&](double phi) {
    return -area * engine.crank_radius *
        (std::cos(phi) + std::sqrt(1 - std::pow(engine.rod_ratio * std::sin(phi), 2)) / engine.rod_ratio);
  };
  double work = 0;
  for (std::size_t i = 0; i < 7200; ++i)
    work += 0.5 * (trace.pressures[i] + trace.pressures[(i + 1) % 7200]) *
        (volume(4 * pi * static_cast<double>(i + 1) / 7200) - volume(trace.angles[i]));
  constexpr double trapezoids = 1e-5;  // of 0.1°
  EXPECT_THAT(4 * pi * gas_harmonics(trace, engine, 0.08, 0)[0].torque.real(), RelativelyNear(work, trapezoids));
}

TEST(GasTorque, AddsUpInMultiplesOfTheFiringOrderIfCylindersFireEvenly) {
  Engine engine{.crank_radius = 0.045, .rod_ratio = 0.3};
  engine.cylinders = evenly_firing_cylinders({.cylinders = 4, .spacing = 0.09});
  const std::vector<TorqueHarmonic> one = {{0, 20}, {0.5, {30, 5}}, {1, {40, -3}}, {2, {25, 12}}, {4, {8, 1}}};
  const std::vector<Order> orders = gas_orders(engine, one);
  ASSERT_EQ(orders.size(), 2u);
  EXPECT_EQ(orders[0].order, 2);
  EXPECT_LE(std::abs(orders[0].fixed(3) + 4.0 * Complex(25, 12)), round_off);  // the block reacts opposite to the crank
  EXPECT_EQ(orders[1].order, 4);
  EXPECT_EQ(mean_torque(engine, one), 80);
  EXPECT_EQ(orders[0].per_speed_squared.norm(), 0);
}

TEST(GasTorque, ALaterFiringAngleLags) {
  Engine engine = one_cylinder();
  engine.cylinders[0].crank_angle = -0.4;
  engine.cylinders[0].firing_angle = 0.4;
  EXPECT_LE(std::abs(gas_orders(engine, {{1.5, 10}}).at(0).fixed(3) + std::polar(10.0, -0.6)), round_off);
}

TEST(GasTorque, FindingsNameTheError) {
  const auto first = [](const PressureTrace& t) { return foundation::message(check(t, 4 * pi, "p.csv").list().at(0)); };
  EXPECT_THAT(first({{0, 2, 1}, {1, 1, 1}}), HasSubstr("angles must increase"));
  EXPECT_THAT(first({{0, 1, not_a_number}, {1, 1, 1}}), HasSubstr("row 3: nan"));
  EXPECT_THAT(first({{0, 1, 2 * pi}, {1, 1, 1}}), HasSubstr("gaps of up to 30°"));
  EXPECT_THAT(first({{0, 1, 5 * pi}, {1, 1, 1}}), HasSubstr("cut the trace to one cycle"));
  EXPECT_THAT(first({{0, 1, 4 * pi}, {1, 1, 2}}), HasSubstr("here it jumps"));
  EXPECT_THAT(first({{0, 1}, {1, 1}}), HasSubstr("2 points"));
  EXPECT_THAT(first({{0, 1, 2}, {1, 1}}), HasSubstr("3 angles and 2 pressures"));
  EXPECT_THROW((void)gas_harmonics(made_trace(one_cylinder(), 90), one_cylinder(), 0, 4), foundation::InvalidInput);
}

}  // namespace slider_crank_test
