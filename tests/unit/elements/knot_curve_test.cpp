// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/knot_curve.h"

#include <gmock/gmock.h>

namespace knot_curve_test {

using trivet::elements::Interpolation;
using trivet::elements::KnotCurve;

TEST(KnotCurve, PassesItsKnotsAndGoesStraightOnBeyondThem) {
  const std::vector<double> x = {-2, 0, 1, 4}, y = {-3, 0, 2, 3};
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::monotone_cubic}) {
    const KnotCurve curve(x, y, interpolation);
    for (std::size_t i = 0; i < x.size(); ++i) EXPECT_DOUBLE_EQ(curve.at(x[i]).value, y[i]);
    for (const double end : {-2.0, 4.0})
      EXPECT_DOUBLE_EQ(curve.at(1.5 * end).value, curve.at(end).value + 0.5 * end * curve.at(1.5 * end).slope);
  }
  EXPECT_DOUBLE_EQ(KnotCurve(x, y, Interpolation::linear).at(2.5).value, 2.5);
}

TEST(KnotCurve, SlopeAndIntegralBelongToTheValue) {
  const std::vector<double> x = {-2, -0.5, 1, 4}, y = {-3, -1, 2, 3};
  constexpr double step = 1e-5, truncation = 1e-8;
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::monotone_cubic}) {
    const KnotCurve curve(x, y, interpolation);
    EXPECT_EQ(curve.integral(-2), 0);
    for (const double at : {-3.0, -1.3, 0.2, 2.7, 6.0}) {
      EXPECT_NEAR((curve.at(at + step).value - curve.at(at - step).value) / (2 * step), curve.at(at).slope, truncation);
      EXPECT_NEAR((curve.integral(at + step) - curve.integral(at - step)) / (2 * step), curve.at(at).value, truncation);
    }
  }
}

}  // namespace knot_curve_test
