// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/elements/law.h"

namespace trivet::elements {

/// Properties of a symmetric, self-balanced 12×12 with N held and K moved: K_KK = [A B; Bᵀ D] at the reference point of
/// K.
struct StiffnessProperties {
  /// Point at which the part of the translation–rotation coupling that a shift can remove is zero: from K [m], in the
  /// element's frame. The coupling is symmetric there; a force through it in a principal direction rotates K only by
  /// the remaining coupling.
  Eigen::Vector3d elastic_centre = Eigen::Vector3d::Zero();
  /// False if A has stiffness in at most one direction: the centre is then any point of a line; the one nearest to K is
  /// given.
  bool centre_is_unique = true;

  Eigen::Vector3d principal_stiffnesses;             ///< eigenvalues of A, ascending [N/m]
  Eigen::Matrix3d principal_axes;                    ///< unit vectors as columns, right-handed
  Eigen::Vector3d principal_rotational_stiffnesses;  ///< eigenvalues of D about the elastic centre, ascending [N m/rad]
  Eigen::Matrix3d principal_rotational_axes;

  /// Largest |K_ij|/√(K_ii K_jj), i a translation and j a rotation: 0 uncoupled, 1 the maximum of a passive element.
  double coupling_at_k = 0;
  double coupling_at_centre =
      0;  ///< the same at the elastic centre along the principal axes: no choice of point and axes removes it

  /// Extreme strain energies of combinations of the six unit motions of K (1 m, 1 rad, each scaled to store ½ alone):
  /// smallest and largest eigenvalue of K_KK over √(K_ii K_jj); both 1 without coupling.
  double softest_combination = 1, stiffest_combination = 1;
};

/// @throws InvalidInput unless the matrix is finite
[[nodiscard]] StiffnessProperties stiffness_properties(const Matrix12& stiffness);

/// Shares of the strain energy of the motion `moved` of K, N held, in three parts of the stiffness: diagonal
/// translational, diagonal rotational, and all off-diagonal entries. They sum to 1; coupling may be negative.
struct EnergyShares {
  double energy = 0;  ///< [J]
  double translation = 0, rotation = 0, coupling = 0;
};
[[nodiscard]] EnergyShares energy_shares(const Matrix12& stiffness, const Vector6& moved);

/// Common simplification: only three springs at the reference point of K with its translational diagonal.
[[nodiscard]] Matrix12 three_springs(const Matrix12& stiffness, const Eigen::Vector3d& arm);

}  // namespace trivet::elements
