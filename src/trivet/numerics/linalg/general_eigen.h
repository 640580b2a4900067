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

}  // namespace trivet::numerics
