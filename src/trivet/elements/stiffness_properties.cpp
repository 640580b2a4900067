// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/stiffness_properties.h"

#include <algorithm>
#include <cmath>

#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::elements {
namespace {

struct Principal {
  Eigen::Vector3d values;
  Eigen::Matrix3d axes;
};

/// Eigenvalues, ascending, and right-handed axes.
Principal principal(const Eigen::Matrix3d& matrix) {
  const numerics::SymmetricEigen<Eigen::Matrix3d> eigen =
      numerics::symmetric_eigen(Eigen::Matrix3d(0.5 * (matrix + matrix.transpose())));
  Principal result{eigen.values, eigen.vectors};
  if (result.axes.col(0).dot(spatial::cross_matrix(result.axes.col(1)) * result.axes.col(2)) < 0)
    result.axes.col(2) *= -1;
  return result;
}

/// The stiffness at the point at r from K.
Matrix6 at_point(const Matrix6& at_k, const Eigen::Vector3d& r) {
  const Matrix6 motion_of_k = spatial::rigid_motion(-r);
  return motion_of_k.transpose() * at_k * motion_of_k;
}

/// Entries over √(K_ii K_jj); rows without diagonal stiffness are 0.
Matrix6 scaled(const Matrix6& stiffness) {
  constexpr double none = 1e-13;  // of the largest of its kind: round-off
  const Vector6 diagonal = stiffness.diagonal();
  Vector6 inverse;
  for (int i = 0; i < 6; ++i) {
    const double largest = (i < 3 ? diagonal.head<3>() : diagonal.tail<3>()).cwiseAbs().maxCoeff();
    inverse(i) = diagonal(i) > none * largest ? 1 / std::sqrt(diagonal(i)) : 0;
  }
  return inverse.asDiagonal() * stiffness * inverse.asDiagonal();
}

double coupling(const Matrix6& stiffness) { return scaled(stiffness).topRightCorner<3, 3>().cwiseAbs().maxCoeff(); }

}  // namespace

StiffnessProperties stiffness_properties(const Matrix12& stiffness) {
  if (!stiffness.allFinite()) throw foundation::InvalidInput("stiffness of an element: every entry must be finite");
  const Matrix6 at_k = 0.5 * (stiffness.bottomRightCorner<6, 6>() + stiffness.bottomRightCorner<6, 6>().transpose());
  const Eigen::Matrix3d a = at_k.topLeftCorner<3, 3>(), b = at_k.topRightCorner<3, 3>();
  StiffnessProperties result;
  const Principal translations = principal(a);
  result.principal_stiffnesses = translations.values;
  result.principal_axes = translations.axes;

  // From r the coupling is A[r]× + B; its skew part vanishes where (tr A I − A) r = −v, v the axial vector of B − Bᵀ.
  const Eigen::Vector3d axial(b(2, 1) - b(1, 2), b(0, 2) - b(2, 0), b(1, 0) - b(0, 1));
  const Eigen::Vector3d resistance = translations.values.sum() - translations.values.array();
  const Eigen::Vector3d wanted = -translations.axes.transpose() * axial;
  Eigen::Vector3d along = Eigen::Vector3d::Zero();
  constexpr double none = 1e-12;
  for (int i = 0; i < 3; ++i) {
    const bool resists = resistance(i) > none * resistance.maxCoeff();
    if (resists) along(i) = wanted(i) / resistance(i);
    result.centre_is_unique = result.centre_is_unique && resists;
  }
  result.elastic_centre = translations.axes * along;

  const Matrix6 at_centre = at_point(at_k, result.elastic_centre);
  const Principal rotations = principal(at_centre.bottomRightCorner<3, 3>());
  result.principal_rotational_stiffnesses = rotations.values;
  result.principal_rotational_axes = rotations.axes;

  const Matrix6 turn = spatial::both_blocks(translations.axes);
  result.coupling_at_k = coupling(at_k);
  result.coupling_at_centre = coupling(turn.transpose() * at_centre * turn);
  const Vector6 combined = numerics::symmetric_eigenvalues(scaled(at_k));
  result.softest_combination = combined(0);
  result.stiffest_combination = combined(5);
  return result;
}

EnergyShares energy_shares(const Matrix12& stiffness, const Vector6& moved) {
  const Matrix6 at_k = stiffness.bottomRightCorner<6, 6>();
  const Vector6 alone = 0.5 * at_k.diagonal().cwiseProduct(moved.cwiseAbs2());
  EnergyShares shares;
  shares.energy = 0.5 * moved.dot(at_k * moved);
  if (!(shares.energy > 0)) return shares;
  shares.translation = alone.head<3>().sum() / shares.energy;
  shares.rotation = alone.tail<3>().sum() / shares.energy;
  shares.coupling = 1 - shares.translation - shares.rotation;
  return shares;
}

Matrix12 three_springs(const Matrix12& stiffness, const Eigen::Vector3d& arm) {
  Vector6 constants = Vector6::Zero();
  constants.head<3>() = stiffness.diagonal().segment<3>(6);
  return constants_at_point(constants, arm, 1);
}

}  // namespace trivet::elements
