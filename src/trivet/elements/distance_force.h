// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/elements/scalar_law.h"

namespace trivet::elements {

/// A force along the line between two points, or across an axis, that follows their finite displacement δ: with the
/// distance ρ = |offset + δ| and the direction u = (offset + δ)/ρ, F = f(ρ − length, ρ̇) u. Struts, and stops within a
/// ring.
struct DistanceForce {
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< between the points at δ = 0, axes of the element [m]
  bool across = false;                               ///< the distance from e3: the third component does not count
  double length = 0;                                 ///< at which the laws begin: free length of a spring [m], ≥ 0
  ScalarLaws laws;                                   ///< over the extension ρ − length, without memory

  [[nodiscard]] double distance(const Eigen::Vector3d& deflection) const;
};

struct SpatialForce {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();          ///< against δ
  Eigen::Matrix3d by_deflection = Eigen::Matrix3d::Zero();  ///< with the geometric stiffness of the force
  Eigen::Matrix3d by_rate = Eigen::Matrix3d::Zero();
};
[[nodiscard]] SpatialForce force_in_motion(const DistanceForce& law, const Eigen::Vector3d& deflection,
                                           const Eigen::Vector3d& rate);

/// ∫ f dρ from δ = 0 [J].
[[nodiscard]] double elastic_energy(const DistanceForce& law, const Eigen::Vector3d& deflection);

/// Distances at which the force is not smooth, ascending.
[[nodiscard]] std::vector<double> kink_distances(const DistanceForce& law);

}  // namespace trivet::elements
