// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace trivet::numerics {

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
