// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/elements/law.h"
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

/// What a force and a moment that an element carries at rest add to its 12×12, because its forces turn with it: the law
/// is that of end K seen in axes that turn with end N. Symmetric, with rotation vectors; a rigid rotation ψ of both
/// ends causes ψ × force and ½ ψ × moment at each end; zero for motions of end K alone.
/// @param on_k  force and moment that the body exerts on end K at rest, axes of K [N, N m]
/// @param arm   from N to K, axes of K [m]
[[nodiscard]] Matrix12 stiffness_of_turning(const Vector6& on_k, const Eigen::Vector3d& arm,
                                            const Eigen::Matrix3d& n_from_k);

/// The same with the exact effect of the axial force of a slender element (Law::per_tension).
[[nodiscard]] Matrix12 stiffness_of_force_at_rest(const Law& law, const Vector6& on_k, const Eigen::Vector3d& arm,
                                                  const Eigen::Matrix3d& n_from_k);

/// Geometric stiffness against rotations about a point, of a force at a lever from it that keeps its direction: the
/// force does ½ force · (θ × (θ × lever)) of work. Positive as of a force on an element.
[[nodiscard]] Eigen::Matrix3d stiffness_of_lever(const Eigen::Vector3d& lever, const Eigen::Vector3d& force);

}  // namespace trivet::elements
