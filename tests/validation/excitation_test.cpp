// SPDX-License-Identifier: BSD-3-Clause
// Roads, balance, shock spectra and modal combination against published definitions and closed forms.
#include <gmock/gmock.h>

#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <numbers>

#include "support/matchers.h"
#include "trivet/excitation/engine_orders.h"
#include "trivet/excitation/pulses_and_sweeps.h"
#include "trivet/excitation/shock_spectrum.h"
#include "trivet/excitation/signal.h"
#include "trivet/excitation/spectrum.h"
#include "trivet/foundation/invalid_input.h"

namespace excitation_test {

using namespace trivet;
using namespace trivet::excitation;
using test::RelativelyNear;
using ::testing::HasSubstr;

constexpr double pi = std::numbers::pi;
constexpr double two_pi = 2 * pi;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double round_off = 1e-12;      // closed forms of some dozens of operations
constexpr double last_digit = 1e-14;     // a handful of operations
constexpr double printed_digits = 5e-4;  // four

TEST(Road, AClassHasTheVelocitySpectrumOfIso8608) {
  // ISO 8608: class C, G_d(0.1 1/m) = 256e-6 m³, at 20 m/s. Velocity density and rms over 0.5 … 50 Hz computed from the
  // definition.
  const Spectrum velocity = differentiated(road_spectrum(road_class('C'), 20), 1);
  EXPECT_THAT(two_pi * density(velocity, two_pi * 5), RelativelyNear(0.0020212949813431004, round_off));
  EXPECT_THAT(two_pi * density(velocity, two_pi * 40), RelativelyNear(0.0020212949813431004, round_off));
  EXPECT_THAT(std::sqrt(mean_square(velocity, two_pi * 0.5, two_pi * 50)),
              RelativelyNear(0.31631329655340684, round_off));
  EXPECT_THAT(velocity.from(), RelativelyNear(two_pi * 0.011 * 20, round_off));
  EXPECT_THAT(velocity.to(), RelativelyNear(two_pi * 2.83 * 20, round_off));
  const double means[] = {1.6e-05, 6.4e-05, 0.000256, 0.001024, 0.004096, 0.016384, 0.065536, 0.262144};
  for (int k = 0; k < 8; ++k)
    EXPECT_THAT(road_class(static_cast<char>('A' + k)).roughness, RelativelyNear(means[k], round_off));
}

TEST(Road, ItsHeightDependsOnTheWavesNotOnTheSpeed) {
  const RoadRoughness road{.roughness = 1e-4, .waviness = 2.5};
  EXPECT_THAT(rms(road_spectrum(road, 10)), RelativelyNear(rms(road_spectrum(road, 33)), round_off));
  // ∫ G (n/n₀)^{−w} dn in closed form.
  const double by_hand = 1e-4 * 0.1 / 1.5 * (std::pow(0.11, -1.5) - std::pow(28.3, -1.5));
  EXPECT_THAT(mean_square(road_spectrum(road, 10)), RelativelyNear(by_hand, round_off));
}

TEST(Balance, G63At3000PerMinuteIsTwentyMicrometres) {
  // ISO 21940-11: e_per = G/ω; G 6.3 at 3000 1/min is 20.05 g mm/kg, the value of its diagram.
  EXPECT_THAT(permissible_unbalance(6.3, 200, 3000 * two_pi / 60) / 200, RelativelyNear(20.05e-6, printed_digits));
  EXPECT_THROW((void)permissible_unbalance(-1, 200, 300), foundation::InvalidInput);
  EXPECT_THROW((void)permissible_unbalance(6.3, 0, 300), foundation::InvalidInput);
  EXPECT_THROW((void)permissible_unbalance(6.3, 200, not_a_number), foundation::InvalidInput);
}

TEST(ShockSpectrum, HalfSineAgreesWithTwoOtherPrograms) {
  // Half sine 50 g, 11 ms, Q = 10: an adaptive Runge–Kutta solution, and the ramp-invariant filter of ISO 18431-4 at
  // 100 kHz, agree to 2e-3 at worst.
  constexpr double between_the_programs = 2e-3, of_the_positive = 2e-5;
  const double rows[][3] = {
      {10, 20.258752278258953, -17.31045360996183}, {20, 39.155563266296085, -33.45717124881133},
      {40, 68.0773720328689, -58.16992848916654},   {60, 80.68026629838644, -68.18823947596796},
      {80, 82.41373492241142, -62.17705634489961},  {100, 79.5697848911771, -43.66864380620587},
      {200, 56.9803002853663, -14.209417108553954}, {500, 52.350937775511724, -3.4949429634871376},
      {1000, 50.37821459733108, -2.176514990107289}};
  for (const auto& [hertz, positive, negative] : rows) {
    const ShockResponse response = shock_spectrum(half_sine(50, 0.011), {two_pi * hertz}, 0.05).at(0);
    EXPECT_THAT(response.largest(), RelativelyNear(positive, of_the_positive));
    EXPECT_THAT(response.smallest(), RelativelyNear(negative, between_the_programs));
  }
}

TEST(ShockSpectrum, UndampedOscillatorHasItsClosedForms) {
  constexpr double of_the_extreme = 1e-11;  // piece by piece in closed form, extremes from the zeros of the velocity
  // Half sine, residual: 2β |cos(π/2β)|/(|β² − 1|) with β = f_pulse/f = 1/(2fT). Rectangle, residual: 2 |sin(πfT)|.
  // [Harris, chapter on shock]
  for (const double fT : {0.1, 0.33, 0.81, 1.27, 2.6, 7.9}) {
    const double omega = two_pi * fT, beta = 1 / (2 * fT);  // T = 1
    const ShockResponse sine = shock_spectrum(half_sine(1, 1), {omega}, 0).at(0),
                        box = shock_spectrum(rectangular(1, 1), {omega}, 0).at(0);
    const double residual = 2 * beta * std::abs(std::cos(pi / (2 * beta))) / std::abs(beta * beta - 1);
    EXPECT_NEAR(sine.residual(), residual, of_the_extreme);
    EXPECT_NEAR(box.residual(), 2 * std::abs(std::sin(pi * fT)), of_the_extreme);
    if (fT >= 0.5) {
      EXPECT_THAT(box.primary(), RelativelyNear(2, of_the_extreme));
    }
    EXPECT_THAT(sine.pseudo_velocity() * omega,
                RelativelyNear(sine.maximax(), of_the_extreme));  // without damping ω²z is the absolute acceleration
  }
  EXPECT_THAT(shock_spectrum(half_sine(1, 1), {two_pi * 0.81}, 0).at(0).maximax(),
              RelativelyNear(1.768, printed_digits));  // the well known peak
  // Exactly at resonance the residual of the half sine is π/2.
  EXPECT_THAT(shock_spectrum(half_sine(1, 1), {pi}, 0).at(0).residual(), RelativelyNear(pi / 2, of_the_extreme));
  // A step has the factor 2, a ramp 1 + |sin(ωt_r/2)|/(ωt_r/2).
  EXPECT_THAT(shock_spectrum(step(1), {5}, 0).at(0).maximax(), RelativelyNear(2, of_the_extreme));
  EXPECT_THAT(shock_spectrum(ramp(1, 1), {5}, 0).at(0).maximax(),
              RelativelyNear(1 + std::abs(std::sin(2.5)) / 2.5, of_the_extreme));
  // A damped step: overshoot of the relative displacement e^{−πζ/√(1−ζ²)}.
  EXPECT_THAT(shock_spectrum(step(1), {5}, 0.2).at(0).relative_displacement * 25,
              RelativelyNear(1 + std::exp(-pi * 0.2 / std::sqrt(0.96)), of_the_extreme));
}

TEST(ShockSpectrum, AnImpulseLeavesItsClosedFormBehind) {
  // A change of velocity V: ωz_max = V exp(−ζ arccos ζ/√(1 − ζ²)), reached after the pulse. The absolute acceleration
  // 2ζωV is largest during the pulse.
  const double duration = 1e-6, short_time = 10 * duration;  // the closed form is the limit of a short pulse
  for (const double zeta : {0.6, 0.8, 0.9}) {
    const ShockResponse response = shock_spectrum(rectangular(1 / duration, duration), {1}, zeta).at(0);
    EXPECT_THAT(response.pseudo_velocity(),
                RelativelyNear(std::exp(-zeta * std::acos(zeta) / std::sqrt(1 - zeta * zeta)), short_time));
    EXPECT_THAT(response.maximax(), RelativelyNear(2 * zeta, short_time));
  }
}

TEST(ShockSpectrum, RejectsASignalWithoutALargestValue) {
  EXPECT_THROW((void)shock_spectrum({{Piece{0, 0, 1}}}, {1}, 0.05), foundation::InvalidInput);
  EXPECT_THROW((void)shock_spectrum(step(1), {0}, 0.05), foundation::InvalidInput);
  EXPECT_THROW((void)shock_spectrum(step(1), {1}, 1), foundation::InvalidInput);
  EXPECT_THROW((void)shock_spectrum(step(1), {1}, not_a_number), foundation::InvalidInput);
  EXPECT_EQ(shock_spectrum({}, {1}, 0.05).at(0).maximax(), 0);
  const auto stop = [](std::string_view, double) { throw foundation::Interrupted(); };
  EXPECT_THROW((void)shock_spectrum(half_sine(1, 1), {1}, 0.05, stop), foundation::Interrupted);
}

TEST(ModalCombination, CorrelationIsThatOfTwoOscillatorsInWhiteNoise) {
  // Exact correlation of displacements under white noise, Re ∫H_i* H_j dω / √(∫|H_i|² ∫|H_j|²), by quadrature. The
  // published coefficient is exact.
  const auto h = [](double omega_n, double zeta, double w) {
    return 1.0 / std::complex<double>(omega_n * omega_n - w * w, 2 * zeta * omega_n * w);
  };
  const auto integral = [&](double wi, double zi, double wj, double zj) {
    double sum = 0;
    constexpr int count = 400000;  // midpoints in w = tan(x), which makes algebraic tails smooth at the ends
    for (int k = 0; k < count; ++k) {
      const double x = pi / 2 * (k + 0.5) / count, w = std::tan(x);
      sum += (std::conj(h(wi, zi, w)) * h(wj, zj, w)).real() * (1 + w * w);
    }
    return sum;
  };
  struct Pair {
    double wi, wj, zi, zj;
  };
  for (const auto& [wi, wj, zi, zj] :
       {Pair{1, 1.1, 0.05, 0.05}, Pair{1, 1.1, 0.02, 0.1}, Pair{1.3, 0.5, 0.1, 0.03}, Pair{1, 1, 0.05, 0.2}}) {
    constexpr double quadrature_error = 1e-6;  // of the midpoints
    const double exact = integral(wi, zi, wj, zj) / std::sqrt(integral(wi, zi, wi, zi) * integral(wj, zj, wj, zj));
    EXPECT_THAT(modal_correlation(wi, wj, zi, zj), RelativelyNear(exact, quadrature_error));
    EXPECT_THAT(modal_correlation(wj, wi, zj, zi), RelativelyNear(modal_correlation(wi, wj, zi, zj), last_digit));
  }
  EXPECT_EQ(modal_correlation(3, 3, 0.05, 0.05), 1);
  EXPECT_EQ(modal_correlation(3, 4, 0, 0), 0);
  EXPECT_EQ(modal_correlation(3, 3, 0, 0), 1);
}

TEST(ModalCombination, GoesFromRootOfSquaresToAlgebraicSum) {
  const Eigen::Vector3d r(3, -4, 12), apart(1, 100, 10000), together(1, 1, 1), zeta = Eigen::Vector3d::Constant(0.02);
  constexpr double correlation_left = 1e-4;  // of frequencies 100 apart: 8 ζ² / 100^1.5, times the terms: below 1e-5
  EXPECT_THAT(square_root_of_sum_of_squares(r), RelativelyNear(13, last_digit));
  EXPECT_THAT(complete_quadratic_combination(r, apart, zeta), RelativelyNear(13, correlation_left));
  EXPECT_THAT(complete_quadratic_combination(r, together, zeta), RelativelyNear(11, last_digit));
  EXPECT_THROW((void)complete_quadratic_combination(r, Eigen::Vector2d(1, 2), zeta), foundation::InvalidInput);
  EXPECT_THROW((void)modal_correlation(0, 1, 0.05, 0.05), foundation::InvalidInput);
  EXPECT_THROW((void)modal_correlation(1, 1, 0.05, 1), foundation::InvalidInput);
}

TEST(ResponseSpectrum, IsStraightOverLogarithms) {
  const ResponseSpectrum spectrum = over_period({0.1, 0.5, 2}, {8, 8, 2}, 0.05);  // falls with 1/T beyond 0.5 s
  EXPECT_THAT(spectral_acceleration(spectrum, two_pi / 1), RelativelyNear(4, round_off));
  EXPECT_THAT(spectral_acceleration(spectrum, two_pi / 0.2), RelativelyNear(8, round_off));
  EXPECT_THAT(spectral_acceleration(spectrum, two_pi / 2), RelativelyNear(2, round_off));
  EXPECT_THROW((void)spectral_acceleration(spectrum, two_pi / 2.1), foundation::InvalidInput);
}

TEST(ResponseSpectrum, FindingsNameTheError) {
  const auto first = [](const ResponseSpectrum& s) { return foundation::message(check(s, "sa.csv").list().at(0)); };
  EXPECT_THAT(first(over_period({0, 1}, {1, 1}, 0.05)), HasSubstr("a natural frequency of inf Hz"));
  EXPECT_THAT(first({{2, 1}, {1, 1}}), HasSubstr("must increase"));
  EXPECT_THAT(first({{1, 2}, {1, -1}}), HasSubstr("acceleration -1 m/s²"));
  EXPECT_THAT(first({{1, 2}, {1}}), HasSubstr("2 frequencies and 1 accelerations"));
  EXPECT_THAT(first({{1}, {1}}), HasSubstr("1 rows"));
  EXPECT_THAT(first({{1, 2}, {1, 1}, 1.5}), HasSubstr("damping ratio 1.5"));
}

}  // namespace excitation_test
