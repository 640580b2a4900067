// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/saturation.h"

#include <gmock/gmock.h>

#include <cmath>

namespace saturation_test {

using namespace trivet::elements;

constexpr double round_off = 1e-14;

TEST(Saturation, IsAnExponentialFunctionOrAHyperbolicTangent) {
  const Saturation first(1), second(2);
  for (double s = 0; s < 40; s += 0.01) {
    EXPECT_NEAR(first.at(s).value, -std::expm1(-s), round_off);
    EXPECT_NEAR(first.at(s).rate, std::exp(-s), round_off);
    EXPECT_NEAR(second.at(s).value, std::tanh(s), round_off);
    EXPECT_NEAR(second.at(s).rate, 1 / (std::cosh(s) * std::cosh(s)), round_off);
  }
}

TEST(Saturation, HasTheTravelOfItsEquation) {
  for (const double n : {1.0, 1.02, 1.5, 3.0, 7.3, 60.0, 1000.0}) {
    const Saturation curve(n);
    for (int i = 0; i < 400; ++i) {
      const double s = i < 200 ? i / 200.0 : 1 + (i - 200) / (25 * n);
      const Saturation::Reached found = curve.at(s);
      EXPECT_NEAR(found.rate, 1 - std::pow(found.value, n), n * round_off) << "n " << n << ", s " << s;
      EXPECT_NEAR((curve.travel(found.value) - s) * found.rate, 0, round_off) << "n " << n << ", s " << s;
    }
  }
}

/// The inverse by a slope: the travel grows by dw/(1 − wⁿ), here by Simpson's rule.
TEST(Saturation, TravelIsTheIntegralOfItsEquation) {
  for (const double n : {1.0, 1.5, 7.3}) {
    const Saturation curve(n);
    const auto slope = [&](double w) { return 1 / (1 - std::pow(w, n)); };
    constexpr int steps = 2000;
    for (const double to : {0.3, 0.8, 0.95}) {
      double sum = slope(0) + slope(to);
      for (int i = 1; i < steps; ++i) sum += (i % 2 == 1 ? 4 : 2) * slope(to * i / steps);
      EXPECT_NEAR(curve.travel(to), sum * to / (3 * steps), 1e-8);
    }
  }
}

TEST(Saturation, IsKeptForEachExponent) {
  const auto first = saturation(1.25);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(saturation(2.0 + i)->exponent(), 2.0 + i);
  EXPECT_EQ(first->exponent(), 1.25);
  EXPECT_EQ(saturation(1.25)->at(0.7).value, first->at(0.7).value);
}

}  // namespace saturation_test
