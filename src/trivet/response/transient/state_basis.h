// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::response {

/// Coordinates in which the state of a system is kept: q = T (p, z, y) with p massive, z held by dashpots without mass,
/// y by springs alone. Matrices are TᵀAT and so on.
struct StateBasis {
  Eigen::MatrixXd T;
  Eigen::Index massive = 0, lagging = 0, following = 0;  ///< numbers of p, z, y
  bool modal = false;                                    ///< p are amplitudes of undamped modes
  Eigen::MatrixXd A;                                     ///< massive × massive
  Eigen::MatrixXd B, K;              ///< all; of modes, K is exactly diagonal and exactly zero for a rigid motion
  Eigen::MatrixXd from_coordinates;  ///< (p, z, y) of q
  Eigen::VectorXd speed;             ///< per p: the natural frequency, or what stands for it [rad/s]
};

/// @throws foundation::NotComputable if a coordinate has neither mass nor stiffness, or moves dashpots that its own
/// rows do not know
[[nodiscard]] StateBasis state_basis(const numerics::DynamicMatrices& matrices);

}  // namespace trivet::response
