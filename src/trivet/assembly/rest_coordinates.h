// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::assembly {

/// Coordinates of K q = Q.
struct RestCoordinates {
  Eigen::VectorXd coordinates;
  bool unique = true;  ///< false: K is singular, and these are the smallest ones that balance what K can balance of Q
};
[[nodiscard]] RestCoordinates coordinates_at_rest(const numerics::DynamicMatrices& m, const Eigen::VectorXd& load);

}  // namespace trivet::assembly
