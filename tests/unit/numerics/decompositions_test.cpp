// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/numerics/linalg/up_to_twelve.h"

namespace decompositions_test {

using namespace trivet;
using Complex = std::complex<double>;

/// Round-off of up to 12 × 12 products of entries up to 3, of matrices with a condition below 100.
constexpr double round_off = 1e4 * std::numeric_limits<double>::epsilon();

/// A regular matrix without symmetry, with the same entries for every type and a large diagonal.
template <typename Matrix>
Matrix sample(Eigen::Index rows, Eigen::Index columns) {
  using Scalar = typename Matrix::Scalar;
  Matrix m(rows, columns);
  for (Eigen::Index i = 0; i < rows; ++i)
    for (Eigen::Index j = 0; j < columns; ++j) {
      const double turn = static_cast<double>(3 * i + 5 * j + i * j);
      if constexpr (Eigen::NumTraits<Scalar>::IsComplex) m(i, j) = Scalar(std::sin(turn), std::cos(turn) / 2);
      else m(i, j) = static_cast<Scalar>(std::sin(turn));
      if (i == j) m(i, j) += Scalar(3);
    }
  return m;
}

/// The matrix in dynamic size: identities are checked there, so that the arithmetic is compiled only once.
template <typename Matrix>
auto dense(const Matrix& m) {
  return Eigen::Matrix<typename Matrix::Scalar, Eigen::Dynamic, Eigen::Dynamic>(m);
}

template <typename Matrix>
Matrix definite(Eigen::Index n) {
  const auto m = dense(sample<Matrix>(n, n));
  return Matrix(m.adjoint() * m);
}

/// Largest entry of a matrix that should be zero.
template <typename Derived>
double rest(const Eigen::MatrixBase<Derived>& m) {
  return static_cast<double>(m.cwiseAbs().maxCoeff());
}

template <typename Matrix>
class SymmetricEigenByType : public testing::Test {};
using SymmetricTypes = testing::Types<Eigen::MatrixXd, Eigen::Matrix2d, Eigen::Matrix3d, Eigen::Matrix<double, 6, 6>,
                                      Eigen::Matrix<double, 12, 12>>;
TYPED_TEST_SUITE(SymmetricEigenByType, SymmetricTypes);

TYPED_TEST(SymmetricEigenByType, SatisfiesItsEquationWithOrthonormalVectorsInAscendingOrder) {
  const Eigen::Index n = TypeParam::RowsAtCompileTime == Eigen::Dynamic ? 7 : TypeParam::RowsAtCompileTime;
  const Eigen::MatrixXd m = sample<TypeParam>(n, n), S = m + m.transpose();
  const auto found = numerics::symmetric_eigen(TypeParam(S));
  const Eigen::MatrixXd vectors = found.vectors;
  const Eigen::VectorXd values = found.values;
  EXPECT_TRUE(found.converged);
  EXPECT_LE(rest(S * vectors - vectors * values.asDiagonal()), round_off);
  EXPECT_LE(rest(vectors.transpose() * vectors - Eigen::MatrixXd::Identity(n, n)), round_off);
  EXPECT_TRUE(std::ranges::is_sorted(found.values));
}

template <typename Matrix>
void expect_eigenvalues(Eigen::Index n) {
  const auto m = dense(sample<Matrix>(n, n));
  const decltype(dense(Matrix())) S = m + m.adjoint();
  const auto values = numerics::symmetric_eigenvalues(Matrix(S));
  for (const double lambda : values) {
    const decltype(dense(Matrix())) shifted = S - lambda * decltype(dense(Matrix()))::Identity(n, n);
    EXPECT_LE(numerics::symmetric_eigenvalues(Matrix(shifted.adjoint() * shifted))(0), round_off) << lambda;
  }
  EXPECT_NEAR(values.sum(), std::real(S.trace()), round_off);
  EXPECT_TRUE(std::ranges::is_sorted(values));
}

TEST(SymmetricEigenvalues, MakeTheMatrixSingularAndAddUpToItsTrace) {
  expect_eigenvalues<Eigen::MatrixXd>(7);
  expect_eigenvalues<Eigen::MatrixXcd>(5);
  expect_eigenvalues<Eigen::Matrix<double, 6, 6>>(6);
  expect_eigenvalues<Eigen::Matrix<double, 12, 12>>(12);
}

template <typename Matrix>
void expect_modes_of_two(int n) {
  const Matrix S = definite<Matrix>(n),
               P = definite<Matrix>(n) + Matrix(Eigen::VectorXd::LinSpaced(n, 1, 4).asDiagonal());
  const numerics::SymmetricEigen<Matrix> found = numerics::symmetric_eigen(S, P);
  EXPECT_LE(rest(S * found.vectors - P * found.vectors * found.values.asDiagonal()), round_off);
  EXPECT_LE(rest(found.vectors.transpose() * P * found.vectors - Matrix::Identity(n, n)), round_off);
}

TEST(SymmetricEigen, SatisfiesTheEquationOfTwoMatrices) {
  expect_modes_of_two<Eigen::Matrix2d>(2);
  expect_modes_of_two<Eigen::MatrixXd>(7);
}

template <typename Matrix>
void expect_general_eigen() {
  const Matrix A = sample<Matrix>(7, 7);
  const numerics::GeneralEigen found = numerics::general_eigen(A), alone = numerics::general_eigenvalues(A);
  EXPECT_TRUE(found.converged && alone.converged);
  EXPECT_LE(rest(A.template cast<Complex>() * found.vectors - found.vectors * found.values.asDiagonal()), round_off);
  EXPECT_LE(rest(found.vectors.colwise().norm().array().matrix() - Eigen::RowVectorXd::Ones(7)), round_off);
  EXPECT_LE(rest(alone.values - found.values), round_off);
  EXPECT_EQ(alone.vectors.size(), 0);
}

TEST(GeneralEigen, SatisfiesItsEquationWithVectorsOfUnitLength) {
  expect_general_eigen<Eigen::MatrixXd>();
  expect_general_eigen<Eigen::MatrixXcd>();
}

TEST(GeneralEigen, ReportsFailureForNumbersThatAreNotFinite) {
  EXPECT_FALSE(numerics::general_eigen(
                   Eigen::MatrixXd(Eigen::MatrixXd::Constant(3, 3, std::numeric_limits<double>::quiet_NaN())))
                   .converged);
}

template <typename Scalar>
void expect_lu() {
  using Lu = numerics::PivotedLu<Scalar>;
  const auto A = sample<typename Lu::Matrix>(9, 9), B = sample<typename Lu::Matrix>(9, 4);
  const typename Lu::Vector b = B.col(2);
  const Lu lu(A);
  EXPECT_LE(rest(A * lu.solve(B) - B), round_off);
  EXPECT_LE(rest(A * lu.solve(b) - b), round_off);
  const double determinant = std::abs(numerics::general_eigenvalues(A).values.prod());
  EXPECT_NEAR(std::abs(lu.pivots().prod()), determinant, round_off * determinant);
  EXPECT_EQ(lu.smallest_pivot(), lu.pivots().cwiseAbs().minCoeff());
  const auto norm = [](const typename Lu::Matrix& m) { return m.cwiseAbs().colwise().sum().maxCoeff(); };
  const double condition = norm(A) * norm(lu.solve(typename Lu::Matrix(Lu::Matrix::Identity(9, 9))));
  EXPECT_LE(1 / lu.reciprocal_condition(), condition * (1 + round_off)) << "the estimate is one from below";
  EXPECT_GE(1 / lu.reciprocal_condition(), condition / 3);
}

TEST(PivotedLu, SolvesForSeveralRightSidesAndEstimatesTheCondition) {
  expect_lu<double>();
  expect_lu<Complex>();
}

template <typename Matrix, typename Right>
void expect_lu_solution(Eigen::Index n, Eigen::Index columns) {
  const Matrix A = sample<Matrix>(n, n);
  const Right B = sample<Right>(n, columns);
  EXPECT_LE(rest(dense(A) * dense(numerics::lu_solution(A, B)) - dense(B)), round_off);
}

TEST(LuSolution, SatisfiesItsEquationForEveryType) {
  using Extended = std::complex<long double>;
  expect_lu_solution<Eigen::MatrixXd, Eigen::MatrixXd>(7, 3);
  expect_lu_solution<Eigen::MatrixXcd, Eigen::VectorXcd>(7, 1);
  expect_lu_solution<Eigen::Matrix<Extended, Eigen::Dynamic, Eigen::Dynamic>,
                     Eigen::Matrix<Extended, Eigen::Dynamic, 1>>(7, 1);
  expect_lu_solution<Eigen::Matrix3d, Eigen::Vector3d>(3, 1);
  expect_lu_solution<Eigen::Matrix<double, 6, 6>, Eigen::Matrix<double, 6, 1>>(6, 1);
  expect_lu_solution<numerics::UpToTwelve<double>, numerics::UpToTwelve<double>>(4, 12);
  expect_lu_solution<numerics::UpToTwelve<Complex>, numerics::UpToTwelve<Complex>>(4, 12);
  expect_lu_solution<Eigen::Matrix<double, 6, 6, Eigen::RowMajor>, Eigen::Matrix<double, 6, 6>>(6, 6);
  expect_lu_solution<Eigen::Matrix<Complex, 6, 6, Eigen::RowMajor>, Eigen::Matrix<Complex, 6, 6>>(6, 6);
  expect_lu_solution<Eigen::Matrix<long double, 6, 6, Eigen::RowMajor>, Eigen::Matrix<long double, 6, 6>>(6, 6);
}

template <typename Matrix>
void expect_inverse(Eigen::Index n) {
  const Matrix A = sample<Matrix>(n, n);
  EXPECT_LE(rest(dense(A) * dense(numerics::inverse(A)) - dense(Matrix::Identity(n, n))), round_off);
}

TEST(Inverse, TimesTheMatrixIsOne) {
  expect_inverse<Eigen::Matrix3d>(3);
  expect_inverse<Eigen::Matrix<double, 6, 6>>(6);
  expect_inverse<Eigen::MatrixXcd>(7);
}

TEST(CompletePivoting, SolvesAndDetectsASingularMatrix) {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  const Matrix6 A = sample<Matrix6>(6, 6);
  const Eigen::Matrix<double, 6, 1> b = A.col(1) + 2 * A.col(4);
  EXPECT_LE(rest(A * numerics::completely_pivoted_solution(A, b) - b), round_off);
  EXPECT_LE(rest(dense(A) * dense(numerics::completely_pivoted_inverse(A)) - dense(Matrix6::Identity())), round_off);
  Matrix6 singular = A;
  singular.col(2) = A.col(1) - A.col(5);
  EXPECT_TRUE(numerics::is_regular(A));
  EXPECT_FALSE(numerics::is_regular(singular));
  EXPECT_TRUE(numerics::is_regular(Eigen::MatrixXd(A), 1e-13));
  EXPECT_FALSE(numerics::is_regular(Eigen::MatrixXd(A), 0.9)) << "the pivots differ by more than that";
}

template <typename Matrix, typename Right>
void expect_cholesky(Eigen::Index n, Eigen::Index columns) {
  const Matrix A = definite<Matrix>(n);
  const Right B = sample<Right>(n, columns);
  EXPECT_LE(rest(dense(A) * dense(numerics::cholesky_solution(A, B)) - dense(B)), round_off);
}

template <typename Matrix, typename Right>
void expect_ldlt(Eigen::Index n, Eigen::Index columns) {
  const Matrix A = definite<Matrix>(n);
  const Right B = sample<Right>(n, columns);
  EXPECT_LE(rest(dense(A) * dense(numerics::ldlt_solution(A, B)) - dense(B)), round_off);
}

TEST(Cholesky, SatisfiesItsEquationForEveryType) {
  expect_cholesky<Eigen::MatrixXd, Eigen::MatrixXd>(7, 3);
  expect_cholesky<Eigen::MatrixXd, Eigen::VectorXd>(7, 1);
  expect_cholesky<Eigen::Matrix3d, Eigen::Vector3d>(3, 1);
  expect_ldlt<Eigen::MatrixXd, Eigen::MatrixXd>(7, 3);
  expect_ldlt<Eigen::MatrixXd, Eigen::VectorXd>(7, 1);
  expect_ldlt<Eigen::Matrix<double, 6, 6>, Eigen::Matrix<double, 6, 12, Eigen::RowMajor>>(6, 12);
}

TEST(Cholesky, HasAsManyNegativePivotsAsNegativeEigenvalues) {
  const Eigen::MatrixXd A = definite<Eigen::MatrixXd>(7);
  const Eigen::VectorXd lambda = numerics::symmetric_eigenvalues(A);
  for (Eigen::Index below = 0; below < 6; ++below) {
    const double shift = 0.5 * (lambda(below) + lambda(below + 1));
    EXPECT_EQ((numerics::ldlt_pivots(A - shift * Eigen::MatrixXd::Identity(7, 7)).array() < 0).count(), below + 1);
  }
}

TEST(SmallestSolution, SolvesWithinTheRowSpaceForAnyRank) {
  const Eigen::MatrixXd left = sample<Eigen::MatrixXd>(8, 3), right = sample<Eigen::MatrixXd>(3, 5), A = left * right;
  const Eigen::MatrixXd B = sample<Eigen::MatrixXd>(8, 2), X = numerics::smallest_solution(A, B);
  EXPECT_LE(rest(A.transpose() * (A * X - B)), 100 * round_off) << "what is left has no part in the columns";
  const Eigen::MatrixXd onto_rows =
      right.transpose() * numerics::cholesky_solution(Eigen::MatrixXd(right * right.transpose()), right);
  EXPECT_LE(rest(onto_rows * X - X), round_off) << "nothing of X is without effect";
  EXPECT_EQ(numerics::ranked_solution(A, B).rank, 3);
  EXPECT_LE(rest(numerics::smallest_solution(A, Eigen::VectorXd(B.col(1))) - X.col(1)), round_off);
  const Eigen::MatrixXcd C = A.cast<Complex>() * Complex(1, 2);
  const Eigen::VectorXcd b = B.col(0).cast<Complex>(), x = numerics::smallest_solution(C, b);
  EXPECT_LE(rest(x * Complex(1, 2) - X.col(0).cast<Complex>()), round_off);
}

TEST(PivotedQr, SolvesInExtendedPrecision) {
  constexpr double extended_round_off = 1e4 * std::numeric_limits<long double>::epsilon();  // as round_off
  const auto A = sample<numerics::ExtendedRealMatrix>(6, 6), B = sample<numerics::ExtendedRealMatrix>(6, 2);
  EXPECT_LE(rest(A * numerics::pivoted_qr_solution(A, B) - B), extended_round_off);
}

TEST(PivotedQr, RestoresTheMatrixAndCountsItsRank) {
  const Eigen::MatrixXd left = sample<Eigen::MatrixXd>(8, 3), right = sample<Eigen::MatrixXd>(3, 5);
  for (const Eigen::MatrixXd& A :
       {Eigen::MatrixXd(left * right), sample<Eigen::MatrixXd>(4, 6), sample<Eigen::MatrixXd>(6, 4)}) {
    const numerics::PivotedQr qr = numerics::pivoted_qr(A, 1e-9);
    const Eigen::Index m = std::min(A.rows(), A.cols());
    EXPECT_EQ(qr.rank, A.rows() == 8 ? 3 : m);
    EXPECT_LE(rest(qr.Q.transpose() * qr.Q - Eigen::MatrixXd::Identity(m, m)), round_off);
    const Eigen::MatrixXd R = qr.R.triangularView<Eigen::Upper>();
    EXPECT_LE(rest(qr.Q * R * qr.P.transpose() - A), round_off);
  }
}

}  // namespace decompositions_test
