// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/balancing.h"

#include <cmath>
#include <utility>
#include <vector>

namespace trivet::fmu {
namespace {

/// Exponent that brings the sums of absolute values of row and column k, without the diagonal, to nearly the same size;
/// 0 if one of them has only zeros.
int exponent_of(const Matrix& a, std::size_t k) {
  double row = 0, column = 0;
  for (std::size_t i = 0; i < a.rows; ++i) {
    if (i == k) continue;
    row += std::abs(a(k, i));
    column += std::abs(a(i, k));
  }
  if (!(row > 0) || !(column > 0) || !std::isfinite(row) || !std::isfinite(column)) return 0;
  int row_power = 0, column_power = 0;
  std::frexp(row, &row_power);
  std::frexp(column, &column_power);
  return (row_power - column_power) / 2;
}

/// Multiplies column k by 2^exponent and divides row k by it.
void scale(Matrix& a, std::size_t k, int exponent) {
  for (std::size_t i = 0; i < a.rows; ++i) {
    if (i == k) continue;
    a(i, k) = std::ldexp(a(i, k), exponent);
    a(k, i) = std::ldexp(a(k, i), -exponent);
  }
}

}  // namespace

Balanced balanced(Matrix a) {
  constexpr int most_rounds = 20;
  std::vector<int> exponents(a.rows, 0);
  bool changed = true;
  for (int round = 0; changed && round < most_rounds; ++round) {
    changed = false;
    for (std::size_t k = 0; k < a.rows; ++k) {
      const int exponent = exponent_of(a, k);
      scale(a, k, exponent);
      exponents[k] += exponent;
      changed = changed || exponent != 0;
    }
  }
  return {std::move(a), std::move(exponents)};
}

int column_exponent(const Matrix& b, std::size_t column) {
  double sum = 0;
  for (std::size_t i = 0; i < b.rows; ++i) sum += std::abs(b(i, column));
  int exponent = 0;
  std::frexp(sum, &exponent);
  return sum > 0 && std::isfinite(sum) ? -exponent : 0;
}

}  // namespace trivet::fmu
