// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/force_at_rest.h"

#include "trivet/spatial/rigid_motion.h"

namespace trivet::elements {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d stiffness_of_lever(const Vector3d& lever, const Vector3d& force) {
  return 0.5 * (lever * force.transpose() + force * lever.transpose()) - lever.dot(force) * Matrix3d::Identity();
}

Matrix12 stiffness_of_turning(const Vector6& on_k, const Vector3d& arm, const Matrix3d& n_from_k) {
  // Second derivative of F·d + M·ρ, with d = −θ_N × (u_K − u_N) + ½ θ_N × (θ_N × arm), ρ = −½ θ_N × θ_K.
  const Vector3d force = on_k.head<3>(), moment = on_k.tail<3>();
  const Matrix3d across = spatial::cross_matrix(force), turned = 0.5 * spatial::cross_matrix(moment);
  Matrix12 stiffness = Matrix12::Zero();
  stiffness.block<3, 3>(3, 0) = -across;
  stiffness.block<3, 3>(0, 3) = across;
  stiffness.block<3, 3>(3, 3) = stiffness_of_lever(arm, force);
  stiffness.block<3, 3>(3, 6) = across;
  stiffness.block<3, 3>(6, 3) = -across;
  stiffness.block<3, 3>(3, 9) = turned;
  stiffness.block<3, 3>(9, 3) = -turned;
  return in_end_axes(stiffness, n_from_k);
}

Matrix12 stiffness_of_force_at_rest(const Law& law, const Vector6& on_k, const Vector3d& arm,
                                    const Matrix3d& n_from_k) {
  if (!law.per_tension) return stiffness_of_turning(on_k, arm, n_from_k);
  constexpr int axial = 2;
  Vector6 others = on_k;
  others(axial) = 0;
  return stiffness_of_turning(others, arm, n_from_k) + on_k(axial) * *law.per_tension;
}

}  // namespace trivet::elements
