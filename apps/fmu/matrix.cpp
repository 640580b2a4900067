// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/matrix.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <vector>

namespace trivet::fmu {
namespace {

void add_row(std::span<double> sum, double factor, std::span<const double> addend) {
  if (factor == 0) return;  // augmented matrices have many zero rows
  for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += factor * addend[j];
}

void swap_rows(Matrix& a, std::size_t i, std::size_t k) {
  if (i != k) std::ranges::swap_ranges(a.row(i), a.row(k));
}

std::size_t pivot_row(const Matrix& a, std::size_t column) {
  std::size_t best = column;
  for (std::size_t i = column + 1; i < a.rows; ++i)
    if (std::abs(a(i, column)) > std::abs(a(best, column))) best = i;
  // The comparison is also false for a number that is not finite.
  if (!(std::abs(a(best, column)) > 0)) throw std::runtime_error("a matrix is singular or not finite");
  return best;
}

}  // namespace

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c(a.rows, b.columns);
  for (std::size_t i = 0; i < a.rows; ++i)
    for (std::size_t k = 0; k < a.columns; ++k) add_row(c.row(i), a(i, k), b.row(k));
  return c;
}

void add(Matrix& sum, double factor, const Matrix& addend) {
  for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += factor * addend.values[i];
}

double one_norm(const Matrix& a) {
  std::vector<double> sums(a.columns, 0.0);
  for (std::size_t i = 0; i < a.rows; ++i)
    for (std::size_t j = 0; j < a.columns; ++j) sums[j] += std::abs(a(i, j));
  return sums.empty() ? 0 : *std::ranges::max_element(sums);
}

Matrix solution(Matrix a, Matrix b) {
  for (std::size_t k = 0; k < a.rows; ++k) {
    const std::size_t pivot = pivot_row(a, k);
    swap_rows(a, k, pivot);
    swap_rows(b, k, pivot);
    for (std::size_t i = k + 1; i < a.rows; ++i) {
      const double factor = -a(i, k) / a(k, k);
      add_row(a.row(i).subspan(k), factor, a.row(k).subspan(k));
      add_row(b.row(i), factor, b.row(k));
    }
  }
  for (std::size_t k = a.rows; k-- > 0;) {
    for (std::size_t j = k + 1; j < a.rows; ++j) add_row(b.row(k), -a(k, j), b.row(j));
    for (double& value : b.row(k)) value /= a(k, k);
  }
  return b;
}

}  // namespace trivet::fmu
