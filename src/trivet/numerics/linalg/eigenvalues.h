// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::numerics {

/// Eigenvalues λ, unordered except that conjugate pairs are adjacent, and eigenvectors as columns of unit length.
struct GeneralEigen {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;  ///< empty if not requested, or if the iteration did not converge
  bool converged = true;
};

/// Eigenvalues and eigenvectors, A v = λ v, of a square unsymmetric A by its Schur form.
[[nodiscard]] GeneralEigen general_eigen(const Eigen::MatrixXd& A);
[[nodiscard]] GeneralEigen general_eigen(const Eigen::MatrixXcd& A);

/// The same without vectors.
[[nodiscard]] GeneralEigen general_eigenvalues(const Eigen::MatrixXd& A);
[[nodiscard]] GeneralEigen general_eigenvalues(const Eigen::MatrixXcd& A);

/// Eigenvalues λ, ascending, and eigenvectors φ as columns of unit length.
template <typename Matrix>
struct SymmetricEigen {
  Eigen::Matrix<double, Matrix::RowsAtCompileTime, 1> values;
  Matrix vectors;
  bool converged = true;
};

/// Solutions of S φ = λ φ for a symmetric S; only its lower triangle is read. Plain matrices only: MatrixXd, Matrix2d,
/// Matrix3d, 6×6 or 12×12.
template <typename Matrix>
[[nodiscard]] SymmetricEigen<Matrix> symmetric_eigen(const Eigen::PlainObjectBase<Matrix>& S);

/// Solutions of S φ = λ P φ with P positive definite, by its Cholesky factor; φᵀ P φ = 1. MatrixXd, Matrix2d.
template <typename Matrix>
[[nodiscard]] SymmetricEigen<Matrix> symmetric_eigen(const Eigen::PlainObjectBase<Matrix>& S,
                                                     const Eigen::PlainObjectBase<Matrix>& P);

/// Eigenvalues of a symmetric or Hermitian matrix, ascending: MatrixXd, MatrixXcd, 6×6 or 12×12.
template <typename Matrix>
[[nodiscard]] Eigen::Matrix<double, Matrix::RowsAtCompileTime, 1> symmetric_eigenvalues(
    const Eigen::PlainObjectBase<Matrix>& S);

}  // namespace trivet::numerics
