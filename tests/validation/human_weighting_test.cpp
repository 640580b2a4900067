// SPDX-License-Identifier: BSD-3-Clause
// Frequency weightings against the design values of ISO 8041-1:2017, table 1 (reference frequencies) and annex B (bands
// 10^(n/10) Hz), four digits, as quoted in the tests of the open program phonometry (jmrplens/phonometry,
// tests/vibration/human/test_human_vibration.py).
#include "trivet/excitation/human_weighting.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/matchers.h"
#include "trivet/foundation/invalid_input.h"

namespace human_weighting_test {

using namespace trivet::excitation;
using trivet::test::RelativelyNear;
using enum Weighting;

constexpr double printed_digits =
    1e-3;  // four digits, the first may be a 1 in the tail of a table: 0.5e-3 and its rounding

TEST(HumanWeighting, HasTheFactorsOfItsReferenceFrequencies) {
  struct Row {
    Weighting weighting;
    double omega, factor;
  };
  for (const auto& [weighting, omega, factor] :
       {Row{Wb, 100, 0.8126}, Row{Wc, 100, 0.5145}, Row{Wd, 100, 0.1261}, Row{We, 100, 0.06287}, Row{Wf, 2.5, 0.3888},
        Row{Wj, 100, 1.019}, Row{Wk, 100, 0.7718}, Row{Wm, 100, 0.3362}})
    EXPECT_THAT(std::abs(transfer(weighting, omega)), RelativelyNear(factor, printed_digits));
}

TEST(HumanWeighting, HasTheFactorsOfItsBands) {
  struct Row {
    Weighting weighting;
    int n;
    double factor;
  };
  for (const auto& [weighting, n, factor] :
       {Row{Wk, 0, 0.4825},    Row{Wk, 8, 1.054},    Row{Wk, 20, 0.08873},   Row{Wk, -10, 0.03121},
        Row{Wd, 0, 1.011},     Row{Wd, 13, 0.1004},  Row{Wd, 26, 0.0003164}, Row{Wc, 1, 1.000},
        Row{Wc, 8, 0.9739},    Row{Wc, 20, 0.05665}, Row{We, 0, 0.8798},     Row{We, 7, 0.2012},
        Row{We, 20, 0.007071}, Row{Wj, 15, 1.000},   Row{Wj, 0, 0.4844},     Row{Wj, 20, 0.7075},
        Row{Wb, 8, 1.054},     Row{Wb, 0, 0.3853},   Row{Wb, 20, 0.1154},    Row{Wf, -8, 1.004},
        Row{Wf, -10, 0.6951},  Row{Wf, 0, 0.02352},  Row{Wm, 2, 0.9342},     Row{Wm, 10, 0.4941},
        Row{Wm, -1, 0.7003},   Row{Wm, 20, 0.04013}})
    EXPECT_THAT(std::abs(transfer(weighting, 2 * std::numbers::pi * std::pow(10, 0.1 * n))),
                RelativelyNear(factor, printed_digits))
        << n;
}

TEST(HumanWeighting, HasTheSeparatelyComputedFactorsOfWkAndWd) {
  // Product of the four parts in frequency, computed separately with all digits.
  const double wk[] = {0.41880607485499177, 0.4588473090762276, 0.47666462758174893, 0.48247335441108624,
                       0.48464631896782806, 0.4934868064593904, 0.5307530271256297,  0.6334835030212541,
                       0.8071022396718057,  0.9647838855679114, 1.0392195351805116,  1.054358667585132,
                       1.0373527291577367,  0.9884056268603463, 0.8989338383358996,  0.7742821887345003,
                       0.6373103399851662,  0.51028710556591,   0.4031145402581323,  0.3160080141847192,
                       0.24512675542473764, 0.1857181165900709, 0.13387420066596742, 0.08872578335575407};
  const double wd[] = {0.8540334319196096,  0.9442905130834398,   0.991360804500541,    1.0110167914793426,
                       1.007054377215816,   0.9707439098205393,   0.8912893517471083,   0.7732672279125696,
                       0.6397720193148595,  0.5143103267959647,   0.4081498862225776,   0.32261953899646717,
                       0.25496907233811117, 0.20170562030658895,  0.15974322262838195,  0.1266134719337828,
                       0.10039327622383695, 0.07958235392844358,  0.06299149357097597,  0.04964829233865022,
                       0.03871766873672398, 0.029456999594646736, 0.021297360776376627, 0.014143493127824992};
  constexpr double all_digits = 1e-12;  // some hundred operations in either program
  for (int i = 0; i < 24; ++i) {
    const double omega = 2 * std::numbers::pi * std::pow(10, 0.1 * (i - 3));
    EXPECT_THAT(std::abs(transfer(Wk, omega)), RelativelyNear(wk[i], all_digits));
    EXPECT_THAT(std::abs(transfer(Wd, omega)), RelativelyNear(wd[i], all_digits));
  }
}

TEST(HumanWeighting, LeadsAndLagsAsItsBandLimitsDo) {
  // Annex B prints the phase of the band limits of Wk: 90.06° at 10^(−0.4) Hz; for We the transition adds −atan2(x/Q, 1
  // − x²) + atan x, x = f/1 Hz.
  const double f = std::pow(10, -0.4), degree = std::numbers::pi / 180;
  const double printed_angle = 0.01 * degree;  // two decimals
  const double expected = 90.06 * degree - std::atan2(f / 0.63, 1 - f * f) + std::atan(f);
  EXPECT_NEAR(std::arg(transfer(We, 2 * std::numbers::pi * f)), expected, printed_angle);
}

TEST(HumanWeighting, IsAProperRationalFunctionThatStopsAtZeroFrequency) {
  for (const Weighting weighting : {Wb, Wc, Wd, We, Wf, Wj, Wk, Wm}) {
    const RationalTransfer h = rational_transfer(weighting);
    EXPECT_LT(h.numerator.size(), h.denominator.size());
    EXPECT_EQ(std::abs(transfer(weighting, 0)), 0);
  }
  EXPECT_THROW((void)transfer(Wk, -1), trivet::foundation::InvalidInput);
  EXPECT_THROW((void)transfer(Wk, std::numeric_limits<double>::quiet_NaN()), trivet::foundation::InvalidInput);
}

TEST(HumanWeighting, TotalsAreRootsOfWeightedSquares) {
  const double a[] = {3, 4, 1}, k[] = {1, 1, 0};
  constexpr double last_digit = 1e-15;  // a root of a sum of two squares
  EXPECT_THAT(vibration_total_value(a, k), RelativelyNear(5, last_digit));
  EXPECT_THROW((void)vibration_total_value(a, std::span(k).first(2)), trivet::foundation::InvalidInput);
}

TEST(HumanWeighting, AxesHaveTheFactorsOfTheStandard) {
  const auto seat = comfort_axes(ContactPoint::seat_surface), back = comfort_axes(ContactPoint::backrest),
             feet = comfort_axes(ContactPoint::feet);
  const double seat_k[] = {1, 1, 1, 0.63, 0.4, 0.2}, back_k[] = {0.8, 0.5, 0.4, 0, 0, 0},
               feet_k[] = {0.25, 0.25, 0.4, 0, 0, 0};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(seat[i].k, seat_k[i]);
    EXPECT_EQ(back[i].k, back_k[i]);
    EXPECT_EQ(feet[i].k, feet_k[i]);
  }
  EXPECT_EQ(seat[2].weighting, Wk);
  EXPECT_EQ(seat[3].weighting, We);
  EXPECT_EQ(back[0].weighting, Wc);
  EXPECT_EQ(comfort_axes(ContactPoint::standing)[0].weighting, Wd);
  EXPECT_EQ(health_axes()[0].k, 1.4);
}

}  // namespace human_weighting_test
