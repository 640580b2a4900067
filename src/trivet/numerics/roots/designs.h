// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::numerics {

/// Many systems of n coordinates with real symmetric matrices, K + iωB − ω²A each: one design per row, the packed lower
/// triangle (entry (i, j), j ≤ i, at i(i+1)/2 + j) in columns, so that adjacent designs are adjacent in memory.
struct Designs {
  Eigen::ArrayXXd A;  ///< designs × n(n+1)/2
  Eigen::ArrayXXd B;
  Eigen::ArrayXXd K;
  Eigen::ArrayXXd load;  ///< designs × n, or 1 × n: the same for all

  [[nodiscard]] Eigen::Index count() const { return A.rows(); }
  [[nodiscard]] Eigen::Index coordinates() const { return load.cols(); }
};

/// @throws foundation::InvalidInput, with `what` as the first words, unless there is at least one coordinate, a row of
/// n(n + 1)/2 entries of A, B and K for every design, and one row of the load or one for every design
void require_shapes(const Designs& designs, const char* what);

/// n of a packed lower triangle of n(n + 1)/2 entries; 0 if there is no such n.
[[nodiscard]] Eigen::Index coordinates_of(Eigen::Index entries);

/// Writes the lower triangle of a symmetric matrix into row `design` of A, B or K.
void pack(const Eigen::MatrixXd& matrix, Eigen::ArrayXXd& packed, Eigen::Index design);

/// Row `design` of A, B or K as a matrix.
[[nodiscard]] Eigen::MatrixXd unpacked(const Eigen::ArrayXXd& packed, Eigen::Index design);

/// Matrices of one design.
[[nodiscard]] DynamicMatrices matrices_of(const Designs& designs, Eigen::Index design);

}  // namespace trivet::numerics
