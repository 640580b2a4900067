// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmock/gmock.h>

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <limits>

namespace trivet::test {

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// |actual − expected| ≤ tolerance · |expected|.
MATCHER_P2(RelativelyNear, expected, tolerance, "") {
  const double difference = std::abs(arg - expected) / std::abs(expected);
  *result_listener << "relative difference " << difference << ", allowed " << tolerance;
  return difference <= tolerance;
}

/// Every entry within `tolerance · scale_i · scale_j` of the expected matrix: makes newtons and newton metres
/// comparable.
MATCHER_P3(NearInUnits, expected, scale, tolerance, "") {
  double worst = 0;
  Eigen::Index row = 0, column = 0;
  for (Eigen::Index i = 0; i < arg.rows(); ++i)
    for (Eigen::Index j = 0; j < arg.cols(); ++j) {
      const double difference = std::abs(arg(i, j) - expected(i, j)) / (scale(i) * scale(j));
      if (!(difference <= worst)) worst = difference, row = i, column = j;
    }
  *result_listener << "entry (" << row << ", " << column << ") is " << arg(row, column) << ", expected "
                   << expected(row, column) << ", scaled difference " << worst << ", allowed " << tolerance;
  return worst <= tolerance;
}

/// The same for a matrix with different scales for columns and rows.
MATCHER_P4(NearInUnitsOf, expected, row_scale, column_scale, tolerance, "") {
  const auto scaled = (arg - expected).cwiseAbs().cwiseQuotient(row_scale * column_scale.transpose()).eval();
  Eigen::Index row = 0, column = 0;
  const double worst = scaled.maxCoeff(&row, &column);
  *result_listener << "entry (" << row << ", " << column << ") is " << arg(row, column) << ", expected "
                   << expected(row, column) << ", scaled difference " << worst << ", allowed " << tolerance;
  return worst <= tolerance;
}

/// Every component of a vector within `tolerance` of the largest.
MATCHER_P2(NearVector, expected, tolerance, "") {
  const double scale = expected.cwiseAbs().maxCoeff();
  Eigen::Index worst = 0;
  const double difference = (arg - expected).cwiseAbs().maxCoeff(&worst) / scale;
  *result_listener << "component " << worst << " is " << arg(worst) << ", expected " << expected(worst)
                   << ", difference " << difference << " of the largest, allowed " << tolerance;
  return difference <= tolerance;
}

}  // namespace trivet::test
