// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/stiffness_fit.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "trivet/elements/law.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"

namespace trivet::identification {

using spatial::Matrix12;

namespace {

spatial::Vector12 entry_scale(const Matrix12& stiffness) {
  constexpr double least_share = 1e-3;
  double mean[2] = {0, 0};
  for (int i = 0; i < 12; ++i) mean[i % 6 < 3 ? 0 : 1] += stiffness(i, i) / 6;
  if (!stiffness.allFinite() || !(mean[0] > 0 && mean[1] > 0))
    throw foundation::InvalidInput("stiffness with mean diagonals " + std::to_string(mean[0]) + " N/m and " +
                                   std::to_string(mean[1]) + " N m/rad, must be finite with means > 0");
  spatial::Vector12 scale;
  for (int i = 0; i < 12; ++i) scale(i) = std::sqrt(std::max(stiffness(i, i), least_share * mean[i % 6 < 3 ? 0 : 1]));
  return scale;
}

}  // namespace

SemidefiniteMatrix nearest_semidefinite(const Matrix12& stiffness, const Eigen::Vector3d& arm) {
  const spatial::Vector12 scale = entry_scale(stiffness);
  const Matrix12 symmetric = 0.5 * (stiffness + stiffness.transpose());
  const Matrix12 scaled = scale.cwiseInverse().asDiagonal() * symmetric * scale.cwiseInverse().asDiagonal();

  // The admissible set is {P M P, M ⪰ 0} with P the projector normal to the rigid motions: its nearest member is P C P
  // without negative eigenvalues.
  const Eigen::Matrix<double, 12, 6> rigid =
      scale.asDiagonal() * elements::rigid_motions(arm, Eigen::Matrix3d::Identity());
  const spatial::Matrix6 gram = rigid.transpose() * rigid;
  const Eigen::Matrix<double, 6, 12, Eigen::RowMajor> transposed = rigid.transpose();
  const Matrix12 beside = Matrix12::Identity() - rigid * numerics::ldlt_solution(gram, transposed);
  const Matrix12 projected = beside * scaled * beside;
  const numerics::SymmetricEigen<Matrix12> eigen =
      numerics::symmetric_eigen(Matrix12(0.5 * (projected + projected.transpose())));
  const Matrix12 clipped = eigen.vectors * eigen.values.cwiseMax(0).asDiagonal() * eigen.vectors.transpose();

  SemidefiniteMatrix result;
  const Matrix12 unscaled = scale.asDiagonal() * clipped * scale.asDiagonal();
  const spatial::Matrix6 moved_end = unscaled.bottomRightCorner<6, 6>();
  result.stiffness =
      elements::from_moved_end(0.5 * (moved_end + moved_end.transpose()), arm);  // equilibrium to round-off
  result.distance = (clipped - scaled).norm() / scaled.norm();
  result.lowest_eigenvalue = eigen.values(0);
  return result;
}

}  // namespace trivet::identification
