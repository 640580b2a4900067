// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

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

/// s^power times a vector of n complex numbers of every design: one design per row, or one row for all.
struct DesignTerm {
  int power = 0;
  Eigen::ArrayXXd re, im;  ///< designs × n, or 1 × n
};

/// y(s) = Σ s^power rowᵀ q(s) + constant, s = iω, with q under one of the loads.
struct DesignCurve {
  std::size_t load = 0;
  std::vector<DesignTerm> rows;
  Eigen::ArrayXXd constant_re, constant_im;  ///< designs × 1, or 1 × 1: of a prescribed motion
};

/// Many systems K + iD + sB + s²A of n coordinates, real symmetric matrices as in Designs, with loss factors (D) and
/// loads h(s) = Σ s^power value. Only for ω > 0.
struct DrivenDesigns {
  Eigen::ArrayXXd A, B, K;  ///< designs × n(n+1)/2
  Eigen::ArrayXXd D;        ///< the same, or empty without loss factors
  std::vector<std::vector<DesignTerm>> loads;
  std::vector<DesignCurve> curves;

  [[nodiscard]] Eigen::Index count() const { return A.rows(); }
};

/// Powers of s that a product of a row and a load may have: without negative powers the curve is bounded at rest, and
/// with 2, the order of the inertia, it tends to a constant for ω → ∞. With more, as the velocity and the acceleration
/// under an unbalance have, it grows like ω² at most: possible for the highest values in a finite band.
inline constexpr int least_power = 0, most_power = 2, most_power_in_band = 4;

inline constexpr int most_driven_coordinates = 12;

}  // namespace trivet::numerics
