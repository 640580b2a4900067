// SPDX-License-Identifier: BSD-3-Clause
// Student's quantiles against printed tables and closed forms.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/matchers.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/sampling/student_distribution.h"

namespace student_distribution_test {

using namespace trivet;
using numerics::student_quantile;

TEST(StudentQuantile, MeetsALongerTable) {
  constexpr double longer_table = 5e-7;  // six decimals
  EXPECT_NEAR(student_quantile(0.95, 10), 2.228139, longer_table);
  EXPECT_NEAR(student_quantile(0.95, 30), 2.042272, longer_table);
  EXPECT_NEAR(student_quantile(0.90, 20), 1.724718, longer_table);
  EXPECT_NEAR(student_quantile(0.99, 5), 4.032143, longer_table);
  EXPECT_NEAR(student_quantile(0.95, std::numeric_limits<double>::infinity()), 1.959964, longer_table);
}

TEST(StudentQuantile, HasClosedFormsForOneTwoAndFourDegreesOfFreedom) {
  constexpr double digits = 1e-12;  // 1 − confidence has no more at 1e-9
  for (const double confidence : {0.1, 0.5, 0.9, 0.95, 0.999, 1 - 1e-9}) {
    const double outside = 1 - confidence, inside = 1 - outside, a = outside * (2 - outside);  // 1 − inside²
    EXPECT_THAT(student_quantile(confidence, 1),
                test::RelativelyNear(1 / std::tan(0.5 * std::numbers::pi * outside), digits));
    EXPECT_THAT(student_quantile(confidence, 2), test::RelativelyNear(inside * std::sqrt(2 / a), digits));
    const double q = std::cos(std::acos(std::sqrt(a)) / 3) / std::sqrt(a);
    EXPECT_THAT(student_quantile(confidence, 4), test::RelativelyNear(2 * std::sqrt(q - 1), digits)) << confidence;
  }
}

TEST(StudentQuantile, RejectsWhatIsNoProbabilityAndIsInfiniteForVanishingFreedom) {
  for (const double confidence : {0.0, 1.0, -0.1, std::nan("")})
    EXPECT_THROW((void)student_quantile(confidence, 5), foundation::InvalidInput);
  for (const double freedom : {0.0, -1.0, std::nan("")})
    EXPECT_THROW((void)student_quantile(0.95, freedom), foundation::InvalidInput);
  EXPECT_EQ(student_quantile(0.95, 1e-3), std::numeric_limits<double>::infinity()) << "1e1299";
}

}  // namespace student_distribution_test
