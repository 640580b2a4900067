// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/periodic/spatial_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "trivet/numerics/periodic/fourier_basis.h"

namespace spatial_motion_test {

using namespace trivet;

/// By the rows of the basis, times the coefficients and those of both derivatives.
TEST(SpatialMotion, HasTheDerivativesOfItsCoefficients) {
  constexpr double round_off = 1e-13;
  Eigen::MatrixXd motion(numerics::coefficient_count(4), 3);
  for (Eigen::Index i = 0; i < motion.rows(); ++i)
    for (Eigen::Index j = 0; j < 3; ++j) motion(i, j) = std::sin(1.0 + 3.0 * static_cast<double>(i + 10 * j));
  Eigen::MatrixXd padded = Eigen::MatrixXd::Zero(numerics::coefficient_count(12), 3);
  padded.topRows(motion.rows()) = motion;
  const Eigen::MatrixXd slope = numerics::phase_derivatives(motion), bend = numerics::phase_derivatives(slope);
  for (const double phase : {0.0, 0.7, 3.0, 6.1}) {
    const Eigen::RowVectorXd row = numerics::fourier_row(4, phase);
    for (const Eigen::MatrixXd& coefficients : {motion, padded}) {
      const auto [value, first, second] = numerics::SpatialMotion(coefficients).at(phase);
      EXPECT_LT((value.transpose() - row * motion).norm(), round_off);
      EXPECT_LT((first.transpose() - row * slope).norm(), 4 * round_off);
      EXPECT_LT((second.transpose() - row * bend).norm(), 16 * round_off);
    }
  }
}

TEST(SpatialMotion, OfRestIsItsPlace) {
  Eigen::MatrixXd rest = Eigen::MatrixXd::Zero(numerics::coefficient_count(3), 3);
  rest.row(0) << 1, 2, 3;
  const auto [value, slope, bend] = numerics::SpatialMotion(rest).at(0.4);
  EXPECT_EQ(value, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(slope, Eigen::Vector3d::Zero());
  EXPECT_EQ(bend, Eigen::Vector3d::Zero());
}

}  // namespace spatial_motion_test
