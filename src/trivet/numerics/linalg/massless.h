// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::numerics {

/// K φ = ω² A φ after static condensation of the coordinates without mass: q = recovery · q_massive.
struct MassiveSystem {
  Eigen::MatrixXd A, K;
  Eigen::MatrixXd recovery;  ///< all × massive
};

/// @throws foundation::NotComputable if a coordinate without mass has no stiffness
[[nodiscard]] MassiveSystem massive_system(const DynamicMatrices& matrices);

/// The system in coordinates q', q = basis · q', in which dampers act on some of the massless coordinates only: their
/// other combinations, such as those across a skew damper, have neither mass nor damping.
struct PartedSystem {
  DynamicMatrices matrices;
  Eigen::MatrixXd basis;
  bool any = false;  ///< false: the given coordinates are such; the rest is empty
};
[[nodiscard]] PartedSystem parted_system(const DynamicMatrices& matrices);

/// The system after condensation of the coordinates with neither mass nor damping: q = recovery · q_kept at every
/// frequency.
struct ReducedSystem {
  DynamicMatrices matrices;
  Eigen::MatrixXcd recovery;  ///< all × kept
  bool any = false;
};

/// @throws foundation::NotComputable if such a coordinate has no stiffness
[[nodiscard]] ReducedSystem reduced_system(const DynamicMatrices& matrices);

}  // namespace trivet::numerics
