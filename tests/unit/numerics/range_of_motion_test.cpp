// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <Eigen/Core>

#include "trivet/numerics/periodic/level_crossings.h"

namespace range_of_motion_test {

using namespace trivet;

/// cos φ + ½ cos 2φ is least where cos φ = −½.
TEST(RangeOfMotion, IsThatOfTheCourse) {
  const auto [low, high] = numerics::range_of_motion(Eigen::VectorXd{{3, 1, 0, 0.5, 0}});
  constexpr double exact = 1e-12;
  EXPECT_NEAR(low, 3 - 0.75, exact);
  EXPECT_NEAR(high, 3 + 1.5, exact);
}

TEST(RangeOfMotion, OfRestIsItsPlace) {
  EXPECT_EQ(numerics::range_of_motion(Eigen::VectorXd{{-2, 0, 0}}), std::pair(-2.0, -2.0));
}

}  // namespace range_of_motion_test
