// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <initializer_list>
#include <string>
#include <utility>

#include "trivet/elements/law.h"
#include "trivet/foundation/problems.h"

namespace trivet::elements {

// Checks used by several elements.

/// Error unless the length [m] is within the limits for parts (foundation/part_size.h); returns whether it is.
bool check_length(foundation::Problems& problems, const std::string& key, double value);

/// The same for several lengths, each reported separately.
bool check_lengths(foundation::Problems& problems, std::initializer_list<std::pair<const char*, double>> lengths);

/// Error at `key` if `width` and `thickness` [m] differ by more than a factor of foundation::most_slender.
void check_slenderness(foundation::Problems& problems, const std::string& key, double width, double thickness);

/// The dynamic stiffening factor: error unless > 0, warning outside 1 … 4.
void check_factor(foundation::Problems& problems, double dynamic_factor);

/// Warning outside 0.25 … 20, the range of shape factors over which the accuracy of the formulas was measured.
void check_shape_factor(foundation::Problems& problems, double shape_factor);

/// Deviation of a given 12×12 from a stress-free passive element. Each entry is scaled by √(K_ii K_jj), so that newtons
/// and newton metres are comparable; a zero diagonal is replaced by the largest entry of its row and column.
struct MatrixVerdict {
  double asymmetry = 0;  ///< largest |C_ij − C_ji|, scaled
  int asymmetric_row = 0, asymmetric_column = 0;
  double lowest_eigenvalue = 0;  ///< of the scaled symmetric part
  double highest_eigenvalue = 0;
  double rigid_residual = 0;  ///< largest entry of C G and Gᵀ C, scaled
  int residual_row = 0, residual_motion = 0;
  Eigen::Matrix<double, 12, 6> residual;  ///< C G minus the expected value: wrench per unit rigid motion, unscaled
};

/// Violation of the rigid-motion rule that gives no message, and the one that is an error.
inline constexpr double silent_residual = 1e-9;
inline constexpr double refused_residual = 0.05;
/// Scaled asymmetry and negative eigenvalue that count as rounding of the data.
inline constexpr double rounding_of_data = 1e-9;

/// `expected`: wrench due to the rotated preload; zero for a stress-free element.
[[nodiscard]] MatrixVerdict examine(
    const Matrix12& matrix, const Eigen::Matrix<double, 12, 6>& rigid_motions,
    const Eigen::Matrix<double, 12, 6>& expected = Eigen::Matrix<double, 12, 6>::Zero());

/// Wrench due to the preload of an element when the whole element rotates by ψ (last three columns, axes of K): ψ ×
/// force and ½ ψ × moment at each end. `preload` in the axes of each end.
[[nodiscard]] Eigen::Matrix<double, 12, 6> turned_preload(const Vector12& preload, const Eigen::Matrix3d& n_from_k);

/// Lowest eigenvalue of the scaled 6×6 of the K end, N held: must not be negative for a preloaded element with a held
/// body.
[[nodiscard]] double lowest_of_held_end(const Matrix12& matrix);

/// Is the symmetric part positive semidefinite, within rounding and the effect of the rigid-motion residual?
[[nodiscard]] bool is_semidefinite(const MatrixVerdict& verdict);

}  // namespace trivet::elements
