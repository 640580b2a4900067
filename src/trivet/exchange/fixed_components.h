// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace trivet::exchange {

/// Rows whose diagonal entry is no stiffness but stands for a component that a boundary condition fixes: Abaqus writes
/// 1e36 there, other programs other large numbers. It is 10¹² times larger than every other entry of its row, which no
/// stress-free element allows (its diagonal balances the others through arms), or ≥ 10³⁰.
[[nodiscard]] std::vector<int> fixed_components(const Eigen::MatrixXd& matrix);

/// Replaces the diagonal entries of these rows by those with which each rigid motion needs no force: with the columns
/// of `motions` turned into unit motions of the end of row i, K_ii = −Σ_{j≠i} K_ij T_j.
/// @param motions  six independent rigid motions of both ends, 12 × 6
[[nodiscard]] Eigen::Matrix<double, 12, 12> completed_by_rigid_motion(const Eigen::Matrix<double, 12, 12>& matrix,
                                                                      const std::vector<int>& rows,
                                                                      const Eigen::Matrix<double, 12, 6>& motions);

}  // namespace trivet::exchange
