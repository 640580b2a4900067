// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/law_harmonics.h"

#include <gmock/gmock.h>

#include <cmath>

#include "support/matchers.h"

namespace law_loops_test {

using namespace trivet;
using nonlinear::LawLoop;
using test::RelativelyNear;

TEST(LawLoops, SliderLosesItsRectangleAndACubeStoresThreeQuarters) {
  const double k = 2e4, slip = 30, cubic = 4e9;
  model::NonlinearPart part;
  part.laws = {elements::HystereticForce(elements::Slider{k, slip}),
               elements::ElasticForce(elements::PolynomialForce{{0, 0, cubic}}),
               elements::DampingForce(elements::QuadraticDamping{60, 60})};
  const std::vector<LawLoop> loops = nonlinear::law_loops(part, 1e5);
  ASSERT_EQ(loops.size(), 5u);
  for (const LawLoop& loop : loops) {
    const double X = loop.amplitude, lost = std::max(0.0, 4 * slip * (X - slip / k));
    EXPECT_NEAR(loop.energy, lost, 1e-8 * k * X * X) << X;
    if (lost == 0) {
      EXPECT_THAT(loop.storage, RelativelyNear(k + 0.75 * cubic * X * X, 1e-9));
    }
    EXPECT_EQ(loop.forces.size(), loop.deflections.size());
    EXPECT_THAT(loop.forces.front(), RelativelyNear(std::min(slip, k * X) + cubic * X * X * X, 1e-9));
  }
  EXPECT_GT(loops.back().energy, 0);
}

}  // namespace law_loops_test
