// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::response {

/// Coordinates of the state: q = T (p, z, y), p with mass, z without mass but with dashpots, y with springs alone.
/// Matrices are TᵀAT and so on.
struct StateBasis {
  Eigen::MatrixXd T;
  Eigen::Index massive = 0, lagging = 0, following = 0;  ///< numbers of p, z, y
  bool modal = false;                                    ///< p are amplitudes of undamped modes
  Eigen::MatrixXd A;                                     ///< massive × massive
  Eigen::MatrixXd B, K;              ///< of all; with modes, K is exactly diagonal, and exactly 0 for a rigid-body mode
  Eigen::MatrixXd from_coordinates;  ///< (p, z, y) from q
  Eigen::VectorXd speed;             ///< per p: the natural frequency, or a scale in its place [rad/s]
};

/// @throws foundation::NotComputable if a coordinate has neither mass nor stiffness, or is coupled by damping without
/// damping of its own
[[nodiscard]] StateBasis state_basis(const numerics::DynamicMatrices& matrices);

}  // namespace trivet::response
