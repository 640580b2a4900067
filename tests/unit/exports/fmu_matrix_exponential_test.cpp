// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/matrix_exponential.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace fmu_matrix_exponential_test {

using trivet::fmu::Matrix;
using trivet::fmu::matrix_exponential;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

Matrix two_by_two(double a, double b, double c, double d) {
  Matrix matrix(2, 2);
  matrix.values = {a, b, c, d};
  return matrix;
}

/// Largest difference of entries over the largest entry of the second matrix.
double difference(const Matrix& found, const Matrix& expected) {
  double largest = 0, scale = 0;
  for (std::size_t i = 0; i < expected.values.size(); ++i) {
    largest = std::max(largest, std::abs(found.values[i] - expected.values[i]));
    scale = std::max(scale, std::abs(expected.values[i]));
  }
  return largest / scale;
}

TEST(FmuMatrixExponential, OfARotationHasSinesAndCosines) {
  for (const double angle : {1e-9, 0.1, 1.0, std::numbers::pi, 30.0, 1000.0}) {
    const Matrix expected = two_by_two(std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle));
    // Each halving doubles the round-off of the approximant; the number of halvings is log2(angle / 5).
    const double tolerance = 20 * epsilon * std::max(1.0, angle);
    EXPECT_LE(difference(matrix_exponential(two_by_two(0, angle, -angle, 0)), expected), tolerance) << angle;
  }
}

TEST(FmuMatrixExponential, OfADiagonalMatrixHasExponentials) {
  const Matrix result = matrix_exponential(two_by_two(3, 0, 0, -200));
  constexpr double tolerance = 1000 * epsilon;  // 6 halvings
  EXPECT_NEAR(result(0, 0), std::exp(3.0), tolerance * std::exp(3.0));
  EXPECT_NEAR(result(1, 1), std::exp(-200.0), tolerance);
  EXPECT_EQ(result(0, 1), 0);
}

TEST(FmuMatrixExponential, OfANilpotentMatrixIsAPolynomial) {
  Matrix chain(3, 3), expected(3, 3);
  chain(0, 1) = chain(1, 2) = 4;
  expected.values = {1, 4, 8, 0, 1, 4, 0, 0, 1};
  EXPECT_LE(difference(matrix_exponential(chain), expected), 10 * epsilon);
}

TEST(FmuMatrixExponential, OfZeroIsTheIdentity) {
  const Matrix result = matrix_exponential(Matrix(2, 2));
  EXPECT_EQ(result.values, two_by_two(1, 0, 0, 1).values);
  EXPECT_TRUE(matrix_exponential(Matrix(0, 0)).values.empty());
}

TEST(FmuMatrixExponential, TimesThatOfTheNegativeMatrixIsTheIdentity) {
  const std::size_t n = 20;
  Matrix matrix(n, n), negative(n, n), identity(n, n);
  std::uint32_t state = 7;
  for (std::size_t i = 0; i < matrix.values.size(); ++i) {
    state = state * 1664525u + 1013904223u;
    matrix.values[i] = state / 4294967296.0 - 0.5;
    negative.values[i] = -matrix.values[i];
  }
  for (std::size_t i = 0; i < n; ++i) identity(i, i) = 1;
  const Matrix result = product(matrix_exponential(matrix), matrix_exponential(negative));
  EXPECT_LE(difference(result, identity), 1e-12);  // the norms of both factors are near 10
}

TEST(FmuMatrixExponential, RejectsWhatIsTooLarge) {
  EXPECT_THROW(static_cast<void>(matrix_exponential(two_by_two(1000, 0, 0, 1))), std::runtime_error);
  EXPECT_THROW(static_cast<void>(matrix_exponential(two_by_two(INFINITY, 0, 0, 1))), std::runtime_error);
  EXPECT_THROW(static_cast<void>(matrix_exponential(two_by_two(NAN, 0, 0, 1))), std::runtime_error);
}

TEST(FmuMatrixSolution, SolvesOnlyRegularSystems) {
  const Matrix x = solution(two_by_two(0, 2, 4, 0), two_by_two(2, 4, 8, 12));  // needs an exchange of rows
  EXPECT_EQ(x.values, two_by_two(2, 3, 1, 2).values);
  EXPECT_THROW(static_cast<void>(solution(two_by_two(1, 2, 2, 4), Matrix(2, 1))), std::runtime_error);
}

}  // namespace fmu_matrix_exponential_test
