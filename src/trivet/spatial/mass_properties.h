// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/spatial/types.h"

namespace trivet::spatial {

/// Mass [kg], centre of mass [m] from the pole and inertia tensor [kg m²] about the centre of mass, in body axes.
/// Products of inertia Jxy = ∫xy dm have a minus sign in the tensor.
struct MassProperties {
  double mass = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia_about_centre = Eigen::Matrix3d::Zero();
};

/// Inertia tensor about the pole, J_O = J_C + m (|c|² I − c cᵀ).
[[nodiscard]] Eigen::Matrix3d inertia_about_pole(const MassProperties& properties);

/// Inverse: mass properties from an inertia tensor about the pole.
[[nodiscard]] MassProperties from_inertia_about_pole(double mass, const Eigen::Vector3d& centre,
                                                     const Eigen::Matrix3d& inertia);

/// Mass matrix A = [m I, Sᵀ; S, J_O], S = m [c]×: kinetic energy ½ q̇ᵀ A q̇ for q at the pole.
[[nodiscard]] Matrix6 mass_matrix(const MassProperties& properties);

/// Principal central moments of inertia [kg m²], ascending, and their axes as columns.
struct PrincipalInertia {
  Eigen::Vector3d moments;
  Eigen::Matrix3d axes;
};
[[nodiscard]] PrincipalInertia principal_inertia(const MassProperties& properties);

/// One violated bound of real bodies.
struct ViolatedBound {
  std::string finding;
  std::string rule;
};

/// Bounds of a real body that these numbers violate: m > 0, positive definite J_C, triangle inequality of its principal
/// moments, each with its amount. Tolerance for rounding: 64 ε of the inertia about the pole, from which J_C is
/// computed as a difference.
[[nodiscard]] std::vector<ViolatedBound> violated_bounds(const MassProperties& properties);

}  // namespace trivet::spatial
