// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/scalar_law.h"

#include <gmock/gmock.h>

namespace damping_force_test {

using namespace trivet::elements;
using testing::ElementsAre;

TEST(DampingForce, QuadraticDamperActsAgainstTheRate) {
  const QuadraticDamping law{60, 20};
  EXPECT_DOUBLE_EQ(force_of_rate(law, 0.5).force, 60 * 0.25);
  EXPECT_DOUBLE_EQ(force_of_rate(law, -0.5).force, -20 * 0.25);
  EXPECT_DOUBLE_EQ(force_of_rate(law, -0.5).by_rate, 20);
  EXPECT_EQ(damping_at_rest(law), 0);
  EXPECT_FALSE(is_piecewise_linear(law));
  EXPECT_THAT(kinks(law), ElementsAre(0));
}

TEST(DampingForce, CurveHasTheMeanSlopeOfBothSensesAtRest) {
  const DampingCurve law{KnotCurve({-1, 0, 0.2, 1}, {-300, 0, 200, 400}, Interpolation::linear)};
  EXPECT_DOUBLE_EQ(force_of_rate(law, 0.6).force, 300);
  EXPECT_DOUBLE_EQ(force_of_rate(law, -0.5).force, -150);
  EXPECT_NEAR(damping_at_rest(law), (300 + 1000) / 2, 1e-9);
  EXPECT_TRUE(is_piecewise_linear(law));
}

}  // namespace damping_force_test
