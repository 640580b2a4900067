// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::numerics {

/// X of A X = B, A symmetric positive definite (lower triangle read), by A = L Lᵀ, of the type of B. MatrixXd with
/// matrix or vector, Matrix3d with vector; only plain matrices are taken. Without meaning unless A is definite.
template <typename Matrix, typename Right>
[[nodiscard]] Right cholesky_solution(const Eigen::PlainObjectBase<Matrix>& A, const Eigen::PlainObjectBase<Right>& B);

/// X of A X = B, A symmetric (lower triangle read) and definite or semidefinite, by Pᵀ L D Lᵀ P with pivots on the
/// diagonal. MatrixXd with matrix or vector, 6×6 with 6×12 by rows; only plain matrices are taken.
template <typename Matrix, typename Right>
[[nodiscard]] Right ldlt_solution(const Eigen::PlainObjectBase<Matrix>& A, const Eigen::PlainObjectBase<Right>& B);

/// D of the same: as many of its entries are negative as eigenvalues of A (Sylvester).
[[nodiscard]] Eigen::VectorXd ldlt_pivots(const Eigen::MatrixXd& A);

}  // namespace trivet::numerics
