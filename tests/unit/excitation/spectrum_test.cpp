// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/spectrum.h"

#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "support/matchers.h"
#include "trivet/foundation/invalid_input.h"

namespace spectrum_test {

using namespace trivet;
using namespace trivet::excitation;
using test::RelativelyNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double two_pi = 2 * std::numbers::pi;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double round_off = 1e-12;      // a few dozen operations, powers and logarithms on numbers of equal size
constexpr double simpsons_error = 1e-9;  // h⁴ of 8000 steps per piece, and the rounding of their sum

/// Mean square by Simpson's rule over log ω within each piece.
double by_quadrature(const Spectrum& spectrum, double from, double to) {
  double sum = 0;
  for (const SpectrumPiece& piece : spectrum.pieces) {
    const double a = std::max({from, piece.from, 1e-9}), b = std::min(to, piece.to);
    if (a >= b) continue;
    constexpr int halves = 4000;
    const Spectrum alone{{piece}};
    const double h = std::log(b / a) / (2 * halves);
    const auto f = [&](int i) {
      const double omega = i == 0 ? a : i == 2 * halves ? b : a * std::exp(i * h);
      return omega * density(alone, omega);
    };
    double part = f(0) + f(2 * halves);
    for (int i = 1; i < 2 * halves; ++i) part += (i % 2 ? 4 : 2) * f(i);
    sum += part * h / 3;
  }
  return sum;
}

const SpectrumTable table{{5, 20, 80, 350, 2000}, {0, 0.01, 0.04, 0.04, 0.007}};

TEST(Spectrum, FollowsItsTableOverLogarithms) {
  const Spectrum s = from_table(table);
  EXPECT_THAT(two_pi * density(s, two_pi * 20), RelativelyNear(0.01, round_off));
  EXPECT_THAT(two_pi * density(s, two_pi * 40), RelativelyNear(0.02, round_off));  // slope 1 on logarithmic axes
  EXPECT_THAT(two_pi * density(s, two_pi * 100), RelativelyNear(0.04, round_off));
  EXPECT_THAT(two_pi * density(s, two_pi * 12.5),
              RelativelyNear(0.005, round_off));  // the piece with a zero is straight
  EXPECT_THAT(two_pi * density(s, two_pi * 2000), RelativelyNear(0.007, round_off));
  EXPECT_EQ(density(s, two_pi * 4.99), 0);
  EXPECT_EQ(density(s, two_pi * 2001), 0);
  EXPECT_THAT(breakpoints(s), ElementsAre(two_pi * 5, two_pi * 20, two_pi * 80, two_pi * 350, two_pi * 2000));
}

TEST(Spectrum, LinearInterpolationIsStraight) {
  const Spectrum s = from_table({{0, 10, 20}, {1, 3, 0}, SpectrumTable::Interpolation::linear});
  EXPECT_THAT(two_pi * density(s, two_pi * 5), RelativelyNear(2, round_off));
  EXPECT_THAT(two_pi * density(s, two_pi * 15), RelativelyNear(1.5, round_off));
  EXPECT_THAT(mean_square(s), RelativelyNear(20 + 15, round_off));
}

TEST(Spectrum, ZerosInsideATableLeaveAGap) {
  const Spectrum s = from_table({{1, 2, 3, 4}, {1, 0, 0, 1}});
  EXPECT_EQ(density(s, two_pi * 2.5), 0);
  EXPECT_THAT(mean_square(s), RelativelyNear(1, round_off));
  EXPECT_THAT(breakpoints(s), ElementsAre(two_pi * 1, two_pi * 2, two_pi * 3, two_pi * 4));
}

TEST(Spectrum, MeanSquareAgreesWithQuadratureForAllPiecesAndDerivatives) {
  const Spectrum linear = from_table({{3, 10, 20}, {1, 3, 0}, SpectrumTable::Interpolation::linear});
  for (const Spectrum& spectrum : {from_table(table), linear})
    for (const int times : {-2, -1, 0, 1, 2}) {
      const Spectrum s = differentiated(spectrum, times);
      EXPECT_THAT(mean_square(s), RelativelyNear(by_quadrature(s, s.from(), s.to()), simpsons_error));
      EXPECT_THAT(mean_square(s, 50, 70), RelativelyNear(by_quadrature(s, 50, 70), simpsons_error));
      for (const double omega : {25.0, 60.0, 100.0})
        EXPECT_THAT(density(s, omega) + 1,
                    RelativelyNear(density(spectrum, omega) * std::pow(omega, 2 * times) + 1, round_off));
    }
}

TEST(Spectrum, ASlopeOfMinusOneIsTheLogarithm) {
  const Spectrum s{{SpectrumPiece{1, 10, 10, 1}}}, nearly{{SpectrumPiece{1, 10, 10, 1 + 1e-13}}};
  EXPECT_THAT(mean_square(s), RelativelyNear(10 * std::log(10), round_off));
  EXPECT_THAT(mean_square(nearly), RelativelyNear(10 * std::log(10), round_off));
}

TEST(Spectrum, DerivativesInvertEachOther) {
  const Spectrum s = from_table(table), back = differentiated(differentiated(s, 2), -2);
  EXPECT_THAT(rms(back), RelativelyNear(rms(s), round_off));
  EXPECT_THAT(rms(of_scaled_signal(s, -9.81)), RelativelyNear(9.81 * rms(s), round_off));
}

TEST(Spectrum, FromZeroHertzItCanOnlyBeDifferentiated) {
  const Spectrum s = flat_spectrum(2, 0, 10);
  EXPECT_THAT(mean_square(s), RelativelyNear(20, round_off));
  EXPECT_THAT(mean_square(differentiated(s, 1)), RelativelyNear(2000.0 / 3, round_off));
  EXPECT_THROW((void)differentiated(s, -1), foundation::InvalidInput);
  EXPECT_THROW((void)flat_spectrum(-1, 0, 10), foundation::InvalidInput);
  EXPECT_THROW((void)flat_spectrum(1, 10, 10), foundation::InvalidInput);
  EXPECT_THROW((void)mean_square(s, 3, 2), foundation::InvalidInput);
  EXPECT_THROW((void)of_scaled_signal(s, 0), foundation::InvalidInput);
}

TEST(Spectrum, BeginsAtItsFirstDensityAboveZero) {
  const Spectrum s = from_table({{0, 1, 2}, {0, 0, 3}, SpectrumTable::Interpolation::linear});
  EXPECT_EQ(s.from(), two_pi);
  EXPECT_GT(rms(differentiated(s, -2)), 0);
}

TEST(Spectrum, FindingsNameTheRow) {
  const auto first = [](const SpectrumTable& t) { return foundation::message(check(t, "psd.csv").list().at(0)); };
  EXPECT_THAT(first({{1, 2}, {1, -3}}), HasSubstr("row 2: density -3 at 2 Hz; a power spectral density"));
  EXPECT_THAT(first({{2, 1}, {1, 1}}), HasSubstr("row 2: 1 Hz after 2 Hz; frequencies must increase; sort the rows"));
  EXPECT_THAT(first({{1, 1}, {1, 1}}), HasSubstr("however close"));
  EXPECT_THAT(first({{1, not_a_number}, {1, 1}}), HasSubstr("row 2: nan Hz, 1; numbers must be finite"));
  EXPECT_THAT(first({{0, 1}, {1, 1}}), HasSubstr("row 1: frequency 0 Hz; logarithmic"));
  EXPECT_THAT(first({{-1, 1}, {1, 1}, SpectrumTable::Interpolation::linear}), HasSubstr("one-sided"));
  EXPECT_THAT(first({{1}, {1}}), HasSubstr("1 rows"));
  EXPECT_THAT(first({{1, 2}, {1}}), HasSubstr("2 frequencies and 1 densities"));
  EXPECT_THAT(first({{1, 2}, {0, 0}}), HasSubstr("every density is 0"));
  EXPECT_THAT(first(table), HasSubstr("density 0 at 5 Hz; 0 has no logarithm"));
  EXPECT_FALSE(check(table, "").has_errors());
  EXPECT_THROW((void)from_table({{1, 2}, {1, -3}}), foundation::InvalidInput);
}

TEST(Road, RejectsInvalidParameters) {
  EXPECT_THROW((void)road_class('I'), foundation::InvalidInput);
  EXPECT_THROW((void)road_spectrum(road_class('C'), 0), foundation::InvalidInput);
  EXPECT_THROW((void)road_spectrum({.roughness = -1}, 20), foundation::InvalidInput);
  EXPECT_THROW((void)road_spectrum({.roughness = 1, .waviness = 2, .wave_number_from = 0}, 20),
               foundation::InvalidInput);
}

RandomInputs two_inputs(double coherent, double delay) {
  return {{flat_spectrum(4, 1, 9), flat_spectrum(9, 1, 9)}, {{0, 1, {coherent}, delay}}};
}

TEST(RandomInputs, TheLaterInputLags) {
  const Eigen::MatrixXcd s = density_matrix(two_inputs(0.25, 0.1), 5);
  EXPECT_THAT(s(0, 0).real(), RelativelyNear(4, round_off));
  EXPECT_THAT(s(1, 1).real(), RelativelyNear(9, round_off));
  EXPECT_NEAR(std::abs(s(0, 1) - std::polar(0.5 * 6, -0.5)), 0, round_off);
  EXPECT_EQ(s(1, 0), std::conj(s(0, 1)));
}

TEST(RandomInputs, AChannelOfTheirSumVanishesInAntiPhase) {
  // x₂(t) = x₁(t − τ): with ωτ = π the sum is zero, with ωτ = 2π it is twice x₁. S_yy = Σ H_j* S_jk H_k.
  const RandomInputs wheels{{flat_spectrum(4, 1, 9), flat_spectrum(4, 1, 9)}, {{0, 1, {}, 1}}};
  EXPECT_NEAR(density_matrix(wheels, std::numbers::pi).sum().real(), 0, round_off);
  EXPECT_THAT(density_matrix(wheels, two_pi).sum().real(), RelativelyNear(16, round_off));
  // Input 2 is the delayed input 1: H = (0, 1) and H = (e^{−iωτ}, 0) give the same signal.
  const Eigen::MatrixXcd s = density_matrix(wheels, 2.2);
  const Eigen::Vector2cd h(std::polar(1.0, -2.2), -1.0);
  EXPECT_NEAR(std::abs((h.adjoint() * s * h).value()), 0, round_off);
}

TEST(RandomInputs, CoherenceDecaysWithDistanceOverWavelength) {
  const Coherence law{0.9, 2, 3, 12};  // at 4 Hz the wavelength is 3 m
  EXPECT_THAT(coherence(law, two_pi * 4), RelativelyNear(0.9 * std::exp(-4), round_off));
  EXPECT_THAT(coherence({0.5}, 100), RelativelyNear(0.5, round_off));
}

TEST(RandomInputs, RejectImpossibleCoherences) {
  const auto first = [](const RandomInputs& inputs) {
    return foundation::message(check(inputs, "random").list().at(0));
  };
  const std::vector<Spectrum> three(3, flat_spectrum(1, 1, 9));
  // 1 with 2 and 2 with 3 fully coherent, 1 with 3 not at all.
  EXPECT_THAT(first({three, {{0, 1}, {1, 2}}}), HasSubstr("eigenvalue -0.414"));
  EXPECT_TRUE(check({three, {{0, 1, {}, 0.3}, {1, 2, {}, 0.5}, {0, 2, {}, 0.8}}}, "").list().empty());
  EXPECT_THAT(first({three, {{0, 1, {}, 0.3}, {1, 2, {}, 0.5}, {0, 2, {}, 0.7}}}), HasSubstr("delays add up"));
  // Wrong by 2π s: correct at the breakpoints 1 and 9 rad/s, wrong between them.
  EXPECT_TRUE(check({three, {{0, 1, {}, 0.3}, {1, 2, {}, 0.5}, {0, 2, {}, 0.8 + two_pi}}}, "").has_errors());
  EXPECT_TRUE(check({three, {{0, 1, {0.4}}, {1, 2, {0.4}}}}, "").list().empty());  // √0.4 √2 < 1
  EXPECT_THAT(first({three, {{0, 3}}}), HasSubstr("two different inputs out of 3"));
  EXPECT_THAT(first({three, {{1, 1}}}), HasSubstr("two different"));
  EXPECT_THAT(first({three, {{0, 1, {1.1}}}}), HasSubstr("coherence 1.1"));
  EXPECT_THAT(first({three, {{0, 1, {1, 1, 1, 0}}}}), HasSubstr("speed 0 m/s"));
  EXPECT_THAT(first({three, {{0, 1}, {1, 0}}}), HasSubstr("twice"));
  EXPECT_THROW((void)density_matrix({three, {{0, 3}}}, 2), foundation::InvalidInput);
}

}  // namespace spectrum_test
