// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace trivet::fmu {

/// A dense matrix, stored by rows.
struct Matrix {
  Matrix() = default;
  Matrix(std::size_t row_count, std::size_t column_count)
      : rows(row_count), columns(column_count), values(row_count * column_count, 0.0) {}

  double& operator()(std::size_t i, std::size_t j) { return values[i * columns + j]; }
  double operator()(std::size_t i, std::size_t j) const { return values[i * columns + j]; }
  [[nodiscard]] std::span<double> row(std::size_t i) { return {values.data() + i * columns, columns}; }
  [[nodiscard]] std::span<const double> row(std::size_t i) const { return {values.data() + i * columns, columns}; }

  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<double> values;
};

[[nodiscard]] double dot(std::span<const double> a, std::span<const double> b);

[[nodiscard]] Matrix product(const Matrix& a, const Matrix& b);

/// Adds factor · addend.
void add(Matrix& sum, double factor, const Matrix& addend);

/// Largest sum of absolute values of a column.
[[nodiscard]] double one_norm(const Matrix& a);

/// X of A X = B, by elimination with row pivoting.
/// @throws std::runtime_error if A is singular or an entry is not finite
[[nodiscard]] Matrix solution(Matrix a, Matrix b);

}  // namespace trivet::fmu
