// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/distance_force.h"

#include "trivet/spatial/rigid_motion.h"

namespace trivet::elements {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

Vector3d line(const DistanceForce& law, const Vector3d& deflection) {
  Vector3d found = law.offset + deflection;
  if (law.across) found.z() = 0;
  return found;
}

ForceInMotion along(const DistanceForce& law, double extension, double rate) {
  ForceInMotion sum;
  for (const ScalarLaw& one : law.laws) {
    if (const auto* elastic = std::get_if<ElasticForce>(&one)) {
      const ForceInMotion found = force_in_motion(*elastic, extension, rate);
      sum.force += found.force;
      sum.by_deflection += found.by_deflection;
      sum.by_rate += found.by_rate;
    }
    if (const auto* damper = std::get_if<DampingForce>(&one)) {
      const ForceOfRate found = force_of_rate(*damper, rate);
      sum.force += found.force;
      sum.by_rate += rate == 0 ? damping_at_rest(*damper) : found.by_rate;
    }
  }
  return sum;
}

}  // namespace

double DistanceForce::distance(const Vector3d& deflection) const { return line(*this, deflection).norm(); }

SpatialForce force_in_motion(const DistanceForce& law, const Vector3d& deflection, const Vector3d& rate) {
  const Vector3d between = line(law, deflection);
  const double distance = between.norm();
  SpatialForce found;
  if (!(distance > 0)) return found;  // no direction; a ring is open there
  const Vector3d u = between / distance;
  Vector3d moving = rate;
  Matrix3d plane = Matrix3d::Identity();
  if (law.across) moving.z() = plane(2, 2) = 0;
  const double speed = u.dot(moving);
  const ForceInMotion scalar = along(law, distance - law.length, speed);
  const Vector3d speed_slope = (moving - speed * u) / distance;  // of the speed by δ
  found.force = scalar.force * u;
  found.by_deflection = u * (scalar.by_deflection * u + scalar.by_rate * speed_slope).transpose() +
      scalar.force / distance * (plane - u * u.transpose());
  found.by_rate = scalar.by_rate * u * u.transpose();
  return found;
}

double elastic_energy(const DistanceForce& law, const Vector3d& deflection) {
  return elastic_energy(law.laws, law.distance(deflection) - law.length) -
      elastic_energy(law.laws, law.distance(Vector3d::Zero()) - law.length);
}

std::vector<double> kink_distances(const DistanceForce& law) {
  std::vector<double> found;
  for (const double extension : kinks_at_rest(law.laws))
    if (extension + law.length > 0) found.push_back(extension + law.length);
  return found;
}

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
