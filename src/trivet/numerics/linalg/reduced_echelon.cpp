// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/reduced_echelon.h"

#include <cassert>
#include <cmath>

namespace trivet::numerics {

Eigen::MatrixXd reduced_echelon(Eigen::MatrixXd rows) {
  [[maybe_unused]] constexpr double of_eigenvectors = 1e-9;
  assert((rows * rows.transpose()).isIdentity(of_eigenvectors) && "pivots of orthonormal rows are no round-off");
  constexpr double no_pivot = 1e-6, zero = 1e-9;
  const Eigen::Index count = rows.rows();
  Eigen::Index pivot_row = 0;
  for (Eigen::Index column = 0; column < rows.cols() && pivot_row < count; ++column) {
    Eigen::Index best = 0;
    if (rows.col(column).tail(count - pivot_row).cwiseAbs().maxCoeff(&best) < no_pivot) continue;
    rows.row(pivot_row).swap(rows.row(pivot_row + best));
    rows.row(pivot_row) /= double(rows(pivot_row, column));
    for (Eigen::Index r = 0; r < count; ++r)
      if (r != pivot_row) rows.row(r) -= (rows(r, column) * rows.row(pivot_row)).eval();
    ++pivot_row;
  }
  return rows.unaryExpr([](double x) { return std::abs(x) < zero ? 0.0 : x; });
}

}  // namespace trivet::numerics
