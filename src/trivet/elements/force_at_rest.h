// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/elements/law.h"

namespace trivet::elements {

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
