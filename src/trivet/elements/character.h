// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/elements/law.h"

namespace trivet::elements {

/// What a symmetric, self-balanced 12×12 does between its ends, N held and K moved: K_KK = [A B; Bᵀ D] at the reference
/// point of K.
struct Character {
  /// Where the part of the translation–rotation coupling that a shift can remove is gone: from K [m], in the element's
  /// frame. Coupling is symmetric there; a force through it in a principal direction turns K only by what is left of
  /// it.
  Eigen::Vector3d elastic_centre = Eigen::Vector3d::Zero();
  /// False if A resists in one direction at most: the centre is then anywhere on a line; the point of it nearest to K
  /// is given.
  bool centre_is_unique = true;

  Eigen::Vector3d principal_stiffnesses;             ///< eigenvalues of A, rising [N/m]
  Eigen::Matrix3d principal_axes;                    ///< unit vectors as columns, right-handed
  Eigen::Vector3d principal_rotational_stiffnesses;  ///< eigenvalues of D about the elastic centre, rising [N m/rad]
  Eigen::Matrix3d principal_rotational_axes;

  /// Largest |K_ij|/√(K_ii K_jj), i a translation and j a rotation: 0 uncoupled, 1 as coupled as a passive element can
  /// be.
  double coupling_at_k = 0;
  double coupling_at_centre =
      0;  ///< the same at the elastic centre along the principal axes: what no choice of point and axes removes

  /// Strain energy of the six unit motions of K (1 m, 1 rad, each scaled to store ½ by itself), moved together in the
  /// worst way: smallest and largest eigenvalue of K_KK over √(K_ii K_jj); both 1 if nothing is coupled.
  double softest_combination = 1, stiffest_combination = 1;
};

/// @throws InvalidInput unless the matrix is finite
[[nodiscard]] Character character(const Matrix12& stiffness);

/// Share of the strain energy of the motion `moved` of K, N held, in the twelve blocks' three parts: the diagonal
/// translational, the diagonal rotational stiffnesses and everything off the diagonal. They sum to 1; coupling may be
/// negative.
struct EnergyShares {
  double energy = 0;  ///< [J]
  double translation = 0, rotation = 0, coupling = 0;
};
[[nodiscard]] EnergyShares energy_shares(const Matrix12& stiffness, const Vector6& moved);

/// The common simplification: three springs at the reference point of K with its translational diagonal, nothing else.
[[nodiscard]] Matrix12 three_springs(const Matrix12& stiffness, const Eigen::Vector3d& arm);

}  // namespace trivet::elements
