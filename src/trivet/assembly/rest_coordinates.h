// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::assembly {

/// Does K hold every coordinate?
[[nodiscard]] bool holds_all(const numerics::DynamicMatrices& m);

/// Coordinates of K q = Q; if K is singular, the smallest ones that balance what K can balance of Q.
[[nodiscard]] Eigen::VectorXd coordinates_at_rest(const numerics::DynamicMatrices& m, const Eigen::VectorXd& load);

}  // namespace trivet::assembly
