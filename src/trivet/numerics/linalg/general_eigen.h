// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::numerics {

/// Eigenvalues λ in no particular order, but conjugate pairs one after the other, and eigenvectors, columns of unit
/// length.
struct GeneralEigen {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;  ///< empty if not asked for, or if the iteration did not converge
  bool converged = true;
};

/// A v = λ v of a square A without symmetry, by its Schur form.
[[nodiscard]] GeneralEigen general_eigen(const Eigen::MatrixXd& A);
[[nodiscard]] GeneralEigen general_eigen(const Eigen::MatrixXcd& A);

/// The same without vectors.
[[nodiscard]] GeneralEigen general_eigenvalues(const Eigen::MatrixXd& A);
[[nodiscard]] GeneralEigen general_eigenvalues(const Eigen::MatrixXcd& A);

}  // namespace trivet::numerics
