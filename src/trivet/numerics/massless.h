// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/dynamic_matrices.h"

namespace trivet::numerics {

/// K φ = ω² A φ without the coordinates that have no mass: they follow the others statically, q = recovery · q_massive.
struct MassiveSystem {
  Eigen::MatrixXd A, K;
  Eigen::MatrixXd recovery;  ///< all × massive
};

/// @throws foundation::NotComputable if a coordinate without mass is held by no stiffness
[[nodiscard]] MassiveSystem massive_system(const DynamicMatrices& matrices);

}  // namespace trivet::numerics
