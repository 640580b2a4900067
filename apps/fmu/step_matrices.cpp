// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/step_matrices.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fmu/balancing.h"
#include "fmu/matrix_exponential.h"

namespace trivet::fmu {
namespace {

constexpr std::size_t kept_sizes = 8;

/// [A, B S, 0; 0, 0, I; 0, 0, 0], of size n + 2m, with S = diag(2^e).
Matrix augmented(const Matrix& a, const Matrix& b, const std::vector<int>& input_exponents) {
  const std::size_t n = a.rows, m = b.columns;
  Matrix large(n + 2 * m, n + 2 * m);
  for (std::size_t i = 0; i < n; ++i) {
    std::ranges::copy(a.row(i), large.row(i).begin());
    for (std::size_t j = 0; j < m; ++j) large(i, n + j) = std::ldexp(b(i, j), input_exponents[j]);
  }
  for (std::size_t j = 0; j < m; ++j) large(n + j, n + m + j) = 1;
  return large;
}

Matrix times(Matrix a, double factor) {
  for (double& value : a.values) value *= factor;
  return a;
}

/// The columns of the block of an exponential that begins at `first`, without the scaling of rows and columns.
Matrix unscaled(const Matrix& exponential, std::size_t first, const std::vector<int>& row_exponents,
                const std::vector<int>& column_exponents) {
  Matrix block(row_exponents.size(), column_exponents.size());
  for (std::size_t i = 0; i < block.rows; ++i)
    for (std::size_t j = 0; j < block.columns; ++j)
      block(i, j) = std::ldexp(exponential(i, first + j), row_exponents[i] - column_exponents[j]);
  return block;
}

}  // namespace

StepMatrix step_matrix(const LinearModel& model, double step) {
  const std::size_t n = model.states(), m = model.inputs();
  const Balanced a = balanced(times(model.a, step));
  Matrix b = times(model.b, step);
  for (std::size_t i = 0; i < n; ++i)
    for (double& value : b.row(i)) value = std::ldexp(value, -a.exponents[i]);
  std::vector<int> input_exponents;
  for (std::size_t j = 0; j < m; ++j) input_exponents.push_back(column_exponent(b, j));

  const Matrix exponential = matrix_exponential(augmented(a.matrix, b, input_exponents));
  return {.step = step,
          .from_states = unscaled(exponential, 0, a.exponents, a.exponents),
          .from_inputs = unscaled(exponential, n, a.exponents, input_exponents),
          .from_slopes = times(unscaled(exponential, n + m, a.exponents, input_exponents), step)};
}

const StepMatrix& StepMatrices::nearest(const LinearModel& model, double step, double tolerance) {
  const auto distance = [&](const StepMatrix& matrix) { return std::abs(matrix.step - step); };
  const auto found = std::ranges::min_element(recent_, {}, distance);
  if (found != recent_.end() && distance(*found) <= tolerance) {
    recent_.splice(recent_.begin(), recent_, found);
    return recent_.front();
  }
  recent_.push_front(step_matrix(model, step));
  ++computed_;
  if (recent_.size() > kept_sizes) recent_.pop_back();
  return recent_.front();
}

}  // namespace trivet::fmu
