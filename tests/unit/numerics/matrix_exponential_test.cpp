// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/matrix_exponential.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <random>

namespace matrix_exponential_test {

using Eigen::MatrixXd;
using trivet::numerics::matrix_exponential;

constexpr double round_off = 1e-13;

TEST(MatrixExponential, OfADefectiveMatrix) {
  // Critical damping: e^{Jt} = e^{λt} [1 t; 0 1].
  for (const double t : {1e-3, 1.0, 30.0}) {
    MatrixXd J(2, 2);
    J << -2 * t, t, 0, -2 * t;
    const MatrixXd e = matrix_exponential(J);
    const double decay = std::exp(-2 * t);
    EXPECT_NEAR(e(0, 0), decay, round_off * decay * 100);
    EXPECT_NEAR(e(0, 1), t * decay, round_off * t * decay * 100);
    EXPECT_EQ(e(1, 0), 0);
  }
}

TEST(MatrixExponential, OfARotationWithinAndBeyondOneTurn) {
  for (const double angle : {0.1, 3.0, 1000.0}) {
    MatrixXd J(2, 2);
    J << 0, -angle, angle, 0;
    const MatrixXd e = matrix_exponential(J);
    const double lost = round_off * std::max(1.0, angle);
    EXPECT_NEAR(e(0, 0), std::cos(angle), lost);
    EXPECT_NEAR(e(1, 0), std::sin(angle), lost);
  }
}

/// A direction that decays by e^−1e6 does not disturb the others.
TEST(MatrixExponential, OfAStiffMatrix) {
  MatrixXd A(2, 2);
  A << -1, 3, 0, -1e6;
  const MatrixXd e = matrix_exponential(A);
  constexpr double of_squaring = 1e-9;  // 20 squarings
  EXPECT_NEAR(e(0, 0), std::exp(-1.0), of_squaring);
  EXPECT_NEAR(e(0, 1), 3 * std::exp(-1.0) / (1e6 - 1), of_squaring);
  EXPECT_NEAR(e(1, 1), 0, of_squaring);
}

TEST(MatrixExponential, DeterminantIsThatOfTheTrace) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  for (int n = 1; n <= 8; ++n) {
    const MatrixXd A = MatrixXd::NullaryExpr(n, n, [&](Eigen::Index, Eigen::Index) { return normal(random); });
    const MatrixXd e = matrix_exponential(A), back = matrix_exponential(-A);
    EXPECT_NEAR(e.determinant() / std::exp(A.trace()), 1, 1e-10);
    EXPECT_LT((e * back - MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff(), 1e-9);
  }
}

}  // namespace matrix_exponential_test
