// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trivet/response/random/basis_integrals.h"

namespace gauss_rules_test {

using namespace trivet;

TEST(GaussRules, IntegratePolynomialsExactlyUpToTheirDegree) {
  constexpr double rounding = 1e-15;
  const auto sixteen = response::gauss_nodes({-1, 1});
  EXPECT_TRUE(std::ranges::is_sorted(sixteen.omega));
  const response::KronrodRule rule = response::kronrod_rule();
  EXPECT_TRUE(std::ranges::is_sorted(rule.node));
  const auto by_sixteen = [&](int degree) { return sixteen.weight.dot(sixteen.omega.array().pow(degree).matrix()); };
  const auto by_kronrod = [&](int degree) { return (rule.kronrod * rule.node.pow(degree)).sum(); };
  const auto by_seven = [&](int degree) { return (rule.gauss * rule.node.pow(degree)).sum(); };
  for (int degree = 0; degree <= 31; ++degree) {
    const double exact = degree % 2 == 0 ? 2.0 / (degree + 1) : 0;
    EXPECT_NEAR(by_sixteen(degree), exact, rounding) << degree;
    if (degree <= 23) {
      EXPECT_NEAR(by_kronrod(degree), exact, rounding) << degree;
    }
    if (degree <= 13) {
      EXPECT_NEAR(by_seven(degree), exact, rounding) << degree;
    }
  }
  // The next even degree 2n misses the square of the monic Legendre polynomial, 2²ⁿ⁺¹ n!⁴/((2n + 1) (2n)!²).
  const auto missed = [](int n) {
    return std::exp((2 * n + 1) * std::numbers::ln2 + 4 * std::lgamma(n + 1) - 2 * std::lgamma(2 * n + 1)) /
        (2 * n + 1);
  };
  EXPECT_NEAR(2.0 / 33 - by_sixteen(32), missed(16), rounding);
  EXPECT_NEAR(2.0 / 15 - by_seven(14), missed(7), rounding);
}

TEST(GaussRules, AreThoseInPrint) {
  // Abramowitz and Stegun, table 25.4; QUADPACK, subroutine QK15.
  constexpr double printed = 1e-15;
  const auto sixteen = response::gauss_nodes({-1, 1});
  EXPECT_NEAR(sixteen.omega(15), 0.989400934991650, printed);
  EXPECT_NEAR(sixteen.weight(15), 0.027152459411754, printed);
  EXPECT_NEAR(sixteen.omega(8), 0.095012509837637, printed);
  EXPECT_NEAR(sixteen.weight(8), 0.189450610455069, printed);
  const response::KronrodRule rule = response::kronrod_rule();
  EXPECT_NEAR(rule.node(14), 0.991455371120812639206854697526329, printed);
  EXPECT_NEAR(rule.kronrod(14), 0.022935322010529224963732008058970, printed);
  EXPECT_NEAR(rule.kronrod(7), 0.209482141084727828012999174891714, printed);
  EXPECT_NEAR(rule.gauss(7), 0.417959183673469387755102040816327, printed);
  EXPECT_EQ(rule.gauss(14), 0);
}

}  // namespace gauss_rules_test
