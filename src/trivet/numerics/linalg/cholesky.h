// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::numerics {

/// Solution X of A X = B by A = L Lᵀ, of the type of B; A is symmetric positive definite, only its lower triangle is
/// read. Plain matrices only: MatrixXd with matrix or vector, Matrix3d with vector. Meaningless unless A is definite.
template <typename Matrix, typename Right>
[[nodiscard]] Right cholesky_solution(const Eigen::PlainObjectBase<Matrix>& A, const Eigen::PlainObjectBase<Right>& B);

/// Solution X of A X = B by Pᵀ L D Lᵀ P with diagonal pivoting; A is symmetric, definite or semidefinite, only its
/// lower triangle is read. Plain matrices only: MatrixXd with matrix or vector, 6×6 with 6×12 by rows.
template <typename Matrix, typename Right>
[[nodiscard]] Right ldlt_solution(const Eigen::PlainObjectBase<Matrix>& A, const Eigen::PlainObjectBase<Right>& B);

/// Diagonal of D in that factorisation: it has as many negative entries as A has negative eigenvalues (Sylvester).
[[nodiscard]] Eigen::VectorXd ldlt_pivots(const Eigen::MatrixXd& A);

/// True if A (symmetric, only its lower triangle is read) is positive definite, for coordinates scaled to a unit
/// diagonal by more than round-off.
[[nodiscard]] bool is_positive_definite(const Eigen::MatrixXd& A);

/// True if A (symmetric, only its lower triangle is read) has no negative eigenvalue beyond round-off, for coordinates
/// scaled to a unit diagonal.
[[nodiscard]] bool is_positive_semidefinite(const Eigen::MatrixXd& A);

}  // namespace trivet::numerics
