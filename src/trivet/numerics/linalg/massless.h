// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::numerics {

/// K φ = ω² A φ without the coordinates that have no mass: they follow the others statically, q = recovery · q_massive.
struct MassiveSystem {
  Eigen::MatrixXd A, K;
  Eigen::MatrixXd recovery;  ///< all × massive
};

/// @throws foundation::NotComputable if a coordinate without mass is held by no stiffness
[[nodiscard]] MassiveSystem massive_system(const DynamicMatrices& matrices);

/// The system without coordinates that have neither mass nor damping: they follow the others at every frequency alike,
/// q = recovery · q_kept.
struct WithoutIdle {
  DynamicMatrices matrices;
  Eigen::MatrixXcd recovery;  ///< all × kept
  bool any = false;
};

/// @throws foundation::NotComputable if such a coordinate is held by no stiffness
[[nodiscard]] WithoutIdle without_idle(const DynamicMatrices& matrices);

}  // namespace trivet::numerics
