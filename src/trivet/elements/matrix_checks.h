// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/elements/law.h"

namespace trivet::elements {

/// How far a given 12×12 is from what a stress-free passive element can have. Everything is scaled entry by entry with
/// √(K_ii K_jj), so that newtons and newton metres compare; a zero diagonal takes the largest entry of its row and
/// column.
struct MatrixVerdict {
  double asymmetry = 0;  ///< largest |C_ij − C_ji|, scaled
  int asymmetric_row = 0, asymmetric_column = 0;
  double lowest_eigenvalue = 0;  ///< of the scaled symmetric part
  double highest_eigenvalue = 0;
  double rigid_residual = 0;  ///< largest entry of C G and Gᵀ C, scaled
  int residual_row = 0, residual_motion = 0;
  Eigen::Matrix<double, 12, 6> residual;  ///< C G less what is expected: wrench per unit rigid motion, unscaled
};

/// Violation of the rigid-motion rule that passes in silence, and the one that is refused.
inline constexpr double silent_residual = 1e-9;
inline constexpr double refused_residual = 0.05;
/// Scaled asymmetry and negative eigenvalue that count as rounding of the data.
inline constexpr double rounding_of_data = 1e-9;

/// `expected`: what a rigid motion may ask for, the turned preload; zero for a stress-free element.
[[nodiscard]] MatrixVerdict examine(
    const Matrix12& matrix, const Eigen::Matrix<double, 12, 6>& rigid_motions,
    const Eigen::Matrix<double, 12, 6>& expected = Eigen::Matrix<double, 12, 6>::Zero());

/// What the preload of an element asks for when the element is turned as a whole by ψ (last three columns, axes of K):
/// ψ × force and ½ ψ × moment at each end. `preload` in the axes of each end.
[[nodiscard]] Eigen::Matrix<double, 12, 6> turned_preload(const Vector12& preload, const Eigen::Matrix3d& n_from_k);

/// Lowest eigenvalue of the scaled 6×6 of the K end, N held: what a preloaded element may not have negative while its
/// body is held.
[[nodiscard]] double lowest_of_held_end(const Matrix12& matrix);

/// Is the symmetric part positive semidefinite, up to rounding and to what the rigid-motion residual itself explains?
[[nodiscard]] bool is_semidefinite(const MatrixVerdict& verdict);

}  // namespace trivet::elements
