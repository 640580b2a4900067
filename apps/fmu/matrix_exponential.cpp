// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/matrix_exponential.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace trivet::fmu {
namespace {

/// Coefficients of the numerator of the approximant, lowest power first.
constexpr std::array<double, 14> pade = {64764752532480000.0,
                                         32382376266240000.0,
                                         7771770303897600.0,
                                         1187353796428800.0,
                                         129060195264000.0,
                                         10559470521600.0,
                                         670442572800.0,
                                         33522128640.0,
                                         1323241920.0,
                                         40840800.0,
                                         960960.0,
                                         16380.0,
                                         182.0,
                                         1.0};

/// Norm up to which the approximant is exact to round-off.
constexpr double largest_norm = 5.371920351148152;

/// Number of halvings that bring a norm to at most `largest_norm`.
int halvings(double norm) {
  if (!std::isfinite(norm)) throw std::runtime_error("a matrix exponential is too large");
  int count = 0;
  for (; norm > largest_norm; norm /= 2) ++count;
  return count;
}

/// c₀ I + c₂ M² + c₄ M⁴ + c₆ M⁶.
Matrix polynomial(const std::array<double, 4>& c, const std::array<Matrix, 3>& even_powers) {
  Matrix sum(even_powers[0].rows, even_powers[0].columns);
  for (std::size_t i = 0; i < sum.rows; ++i) sum(i, i) = c[0];
  for (std::size_t k = 0; k < even_powers.size(); ++k) add(sum, c[k + 1], even_powers[k]);
  return sum;
}

/// Half of the numerator, as a polynomial of M²: the coefficients with this parity.
Matrix half_numerator(std::size_t first, const std::array<Matrix, 3>& even_powers) {
  const auto coefficient = [&](std::size_t power) { return pade[power + first]; };
  const Matrix high = polynomial({0, coefficient(8), coefficient(10), coefficient(12)}, even_powers);
  Matrix sum = product(even_powers[2], high);
  add(sum, 1, polynomial({coefficient(0), coefficient(2), coefficient(4), coefficient(6)}, even_powers));
  return sum;
}

Matrix approximant(const Matrix& m) {
  const Matrix square = product(m, m), fourth = product(square, square);
  const std::array<Matrix, 3> even_powers = {square, fourth, product(fourth, square)};
  const Matrix odd = product(m, half_numerator(1, even_powers));
  Matrix numerator = half_numerator(0, even_powers), denominator = numerator;
  add(numerator, 1, odd);
  add(denominator, -1, odd);
  return solution(denominator, numerator);
}

}  // namespace

Matrix matrix_exponential(Matrix m) {
  const int count = halvings(one_norm(m));
  for (double& value : m.values) value = std::ldexp(value, -count);
  Matrix result = approximant(m);
  for (int i = 0; i < count; ++i) result = product(result, result);
  if (!std::ranges::all_of(result.values, [](double value) { return std::isfinite(value); }))
    throw std::runtime_error("a matrix exponential is too large");
  return result;
}

}  // namespace trivet::fmu
