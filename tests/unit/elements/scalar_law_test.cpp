// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/scalar_law.h"

#include <gmock/gmock.h>

#include <cmath>

namespace scalar_law_test {

using namespace trivet::elements;
using testing::ElementsAre;

const std::vector<ScalarLaws>& laws() {
  static const std::vector<ScalarLaws> all = {
      {PolynomialForce{{3, -2, 5, 7}}},
      {GapStop{.gap_above = 0.3, .gap_below = 0.4, .stiffness = 20}},
      {GapStop{.gap_above = -0.1, .stiffness = 20, .power = 1.5}},
      {GapStop{.gap_below = 0.2, .stiffness = 5, .power = 2}, PolynomialForce{{0, 0, 4}}},
      {GapStop{.gap_above = 0.1,
               .gap_below = 0.2,
               .curve = KnotCurve({0, 0.3, 0.6}, {0, 5, 20}, Interpolation::monotone_cubic)}}};
  return all;
}

TEST(ScalarLaw, TangentIsTheSlopeOfTheForceAndForceThatOfTheEnergy) {
  constexpr double step = 1e-4, truncation = 1e-6;  // step² times third derivatives
  for (const ScalarLaws& law : laws())
    for (const double x : {-0.9, -0.35, -0.15, 0.05, 0.25, 0.8}) {
      const ForceAndTangent here = force_at_rest(law, x);
      EXPECT_NEAR((force_at_rest(law, x + step).force - force_at_rest(law, x - step).force) / (2 * step), here.tangent,
                  truncation);
      EXPECT_NEAR((elastic_energy(law, x + step) - elastic_energy(law, x - step)) / (2 * step), here.force, truncation);
      EXPECT_EQ(elastic_energy(law, 0), 0);
    }
}

TEST(ScalarLaw, StopActsBeyondItsGapOnly) {
  const ScalarLaws stop = {GapStop{.gap_above = 0.3, .gap_below = 0.4, .stiffness = 20}};
  EXPECT_EQ(force_at_rest(stop, 0.29).force, 0);
  EXPECT_EQ(force_at_rest(stop, -0.39).tangent, 0);
  EXPECT_DOUBLE_EQ(force_at_rest(stop, 0.5).force, 20 * (0.5 - 0.3));
  EXPECT_DOUBLE_EQ(force_at_rest(stop, -0.5).force, -20 * (0.5 - 0.4));
  EXPECT_THAT(kinks_at_rest(stop), ElementsAre(-0.4, 0.3));
  EXPECT_THAT(kinks_at_rest({GapStop{.gap_above = 0.3, .stiffness = 20}}), ElementsAre(0.3));
  const KnotCurve curve({0, 0.1, 0.3}, {0, 2, 9}, Interpolation::linear);
  EXPECT_THAT(kinks_at_rest({GapStop{.gap_above = 1, .gap_below = 2, .curve = curve}}),
              testing::Pointwise(testing::DoubleNear(1e-15), {-2.3, -2.1, -2.0, 1.0, 1.1, 1.3}));
  EXPECT_TRUE(kinks_at_rest({PolynomialForce{{1}}}).empty());
}

}  // namespace scalar_law_test
