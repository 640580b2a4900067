// SPDX-License-Identifier: BSD-3-Clause
// Eigenproblems of so many coordinates that LAPACK solves them where it is installed.
#include <gmock/gmock.h>

#include <algorithm>
#include <complex>
#include <limits>
#include <random>

#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/numerics/linalg/generalized_modes.h"

namespace large_eigen_test {

using namespace trivet::numerics;

constexpr Eigen::Index size = 75;
constexpr double round_off = 1e-12;  // some hundred operations on entries near 1

Eigen::MatrixXd random(unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd matrix(size, size);
  for (double& entry : matrix.reshaped()) entry = normal(generator);
  return matrix;
}

TEST(LargeEigenproblem, SymmetricPairHasOrthonormalVectors) {
  const Eigen::MatrixXd x = random(1), y = random(2), S = x + x.transpose(),
                        P = y * y.transpose() / size + Eigen::MatrixXd::Identity(size, size);
  const auto found = symmetric_eigen(S, P);
  ASSERT_TRUE(found.converged);
  const Eigen::MatrixXd unit = found.vectors.transpose() * P * found.vectors;
  EXPECT_LE((unit - Eigen::MatrixXd::Identity(size, size)).cwiseAbs().maxCoeff(), round_off);
  const Eigen::MatrixXd rest = S * found.vectors - P * found.vectors * found.values.asDiagonal();
  EXPECT_LE(rest.cwiseAbs().maxCoeff(), round_off * S.norm());
  EXPECT_TRUE(std::ranges::is_sorted(found.values));
  EXPECT_LE((symmetric_eigenvalues(S) - symmetric_eigen(S).values).cwiseAbs().maxCoeff(), round_off * S.norm());
  EXPECT_NEAR(symmetric_eigenvalues(S).sum(), S.trace(), round_off * S.norm());
}

TEST(LargeEigenproblem, GeneralMatrixHasConjugatePairsAndSmallResiduals) {
  const Eigen::MatrixXd A = random(3);
  const GeneralEigen found = general_eigen(A);
  ASSERT_TRUE(found.converged);
  const Eigen::MatrixXcd rest = A * found.vectors - found.vectors * found.values.asDiagonal();
  EXPECT_LE(rest.cwiseAbs().maxCoeff(), round_off * A.norm());
  EXPECT_LE(std::abs(found.values.sum() - A.trace()), round_off * A.norm());
  for (Eigen::Index k = 0; k < size; ++k) {
    EXPECT_NEAR(found.vectors.col(k).norm(), 1, round_off);
    if (found.values(k).imag() > 0) {
      EXPECT_EQ(found.values(k + 1), std::conj(found.values(k)));
    }
  }
  EXPECT_LE(std::abs(general_eigenvalues(A).values.sum() - A.trace()), round_off * A.norm());
}

TEST(LargeEigenproblem, ComplexMatrixHasSmallResiduals) {
  const Eigen::MatrixXcd A =
      random(4).cast<std::complex<double>>() + std::complex<double>(0, 1) * random(5).cast<std::complex<double>>();
  const GeneralEigen found = general_eigen(A);
  ASSERT_TRUE(found.converged);
  const Eigen::MatrixXcd rest = A * found.vectors - found.vectors * found.values.asDiagonal();
  EXPECT_LE(rest.cwiseAbs().maxCoeff(), round_off * A.norm());
  EXPECT_LE(std::abs(general_eigenvalues(A).values.sum() - A.trace()), round_off * A.norm());
}

TEST(LargeEigenproblem, IsNotConvergedForNan) {
  Eigen::MatrixXd A = random(9);
  A(5, 6) = A(6, 5) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(general_eigen(A).converged);
  EXPECT_FALSE(general_eigen(Eigen::MatrixXcd(A.cast<std::complex<double>>())).converged);
  EXPECT_FALSE(symmetric_eigen(Eigen::MatrixXd(A + A.transpose())).converged);
}

TEST(QuadraticForm, IsThatOfTheWholeMatrix) {
  Eigen::MatrixXd M = random(6);
  M(3, 7) = M(7, 3) = 0;
  const Eigen::VectorXd v = random(7).col(0);
  const QuadraticForm form(M);
  EXPECT_NEAR(static_cast<double>(form(v)), v.dot(M * v), round_off * form.terms(v));
  EXPECT_NEAR(form.terms(v), v.cwiseAbs().dot(M.cwiseAbs() * v.cwiseAbs()), round_off * form.terms(v));
}

TEST(Definiteness, DistinguishesZeroFromNegativeEigenvalues) {
  const Eigen::MatrixXd x = random(8).leftCols(5);
  const Eigen::MatrixXd low_rank = x * x.transpose();
  EXPECT_TRUE(is_positive_semidefinite(low_rank));
  EXPECT_FALSE(is_positive_definite(low_rank));
  EXPECT_TRUE(is_positive_semidefinite(Eigen::MatrixXd::Zero(size, size)));
  EXPECT_TRUE(is_positive_definite(low_rank + Eigen::MatrixXd::Identity(size, size)));
  Eigen::MatrixXd negative = low_rank;
  negative -= 1e-6 * low_rank.norm() * Eigen::MatrixXd::Identity(size, size);
  EXPECT_FALSE(is_positive_semidefinite(negative));
  Eigen::MatrixXd skew_zero = Eigen::MatrixXd::Zero(size, size);  // [0 1; 1 0] has the eigenvalue −1
  skew_zero(4, 9) = skew_zero(9, 4) = 1;
  EXPECT_FALSE(is_positive_semidefinite(skew_zero));
}

}  // namespace large_eigen_test
