// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::modal {

/// Vectors of a singular matrix: Z right = 0 and leftᵀ Z = 0, as columns.
struct NullVectors {
  Eigen::MatrixXcd left, right;
};

/// By inverse iteration. @param scale  D that makes D Z D comparable, see numerics::unit_scale
/// @param count  dimension of the null space
[[nodiscard]] NullVectors null_vectors(const Eigen::MatrixXcd& Z, const Eigen::VectorXd& scale, Eigen::Index count);

}  // namespace trivet::modal
