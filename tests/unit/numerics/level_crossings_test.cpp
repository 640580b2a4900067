// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/periodic/level_crossings.h"

#include <gmock/gmock.h>

#include <cmath>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace level_crossings_test {

using namespace trivet;
using foundation::two_pi;

constexpr Eigen::Index samples = 16;
constexpr double step = two_pi / samples, exact = 1e-12;

Eigen::MatrixXd basis(Eigen::Index harmonics) {
  Eigen::MatrixXd rows(samples, numerics::coefficient_count(harmonics));
  for (Eigen::Index n = 0; n < samples; ++n)
    rows.row(n) = numerics::fourier_row(harmonics, step * static_cast<double>(n));
  return rows;
}

/// cos(φ − top)
std::vector<double> crossings(double top, double level) {
  return numerics::level_crossings(Eigen::VectorXd{{0, std::cos(top), std::sin(top)}}, {level}, basis(1));
}

TEST(LevelCrossings, FindsTwoAroundATopBetweenTwoSamples) {
  const double top = 5.5 * step, level = (1 + std::cos(step / 2)) / 2;  // above all samples
  EXPECT_THAT(crossings(top, level),
              testing::ElementsAre(testing::DoubleNear(top - std::acos(level), exact),
                                   testing::DoubleNear(top + std::acos(level), exact)));
  EXPECT_THAT(crossings(top, 1 + 1e-9), testing::IsEmpty());
}

TEST(LevelCrossings, FindsTwoAroundATopAtTheStartOfThePeriod) {
  const double level = 1 - 1e-6, away = std::acos(level);
  EXPECT_THAT(crossings(0, level),
              testing::ElementsAre(testing::DoubleNear(away, 1e-9), testing::DoubleNear(two_pi - away, 1e-9)));
}

TEST(LevelCrossings, OfSeveralLevelsAscend) {
  const std::vector<double> found =
      numerics::level_crossings(Eigen::VectorXd{{0, 0, 1, 0, 0.4}}, {-0.3, 0.3}, basis(2));
  EXPECT_EQ(found.size(), 4u);
  for (std::size_t i = 0; i + 1 < found.size(); ++i) EXPECT_LT(found[i], found[i + 1]);
  for (const double phase : found)
    EXPECT_NEAR(std::abs(std::sin(phase) + 0.4 * std::sin(2 * phase)), 0.3, exact) << phase;
}

}  // namespace level_crossings_test
