// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

/// Eigenproblems of many coordinates by LAPACK, if its library is found at run time: blocked algorithms take a tenth
/// (symmetric) to a quarter (general) of the time of Eigen's (docs/decisions/many-coordinates.md). Finite matrices
/// only.
namespace trivet::numerics::lapack {

/// Larger problems go to LAPACK: measured, from here on it is faster than Eigen.
inline constexpr Eigen::Index least_size = 60;

[[nodiscard]] bool is_available();

/// Eigenvalues, ascending, and orthonormal vectors in place of the symmetric matrix. @return false if not converged
[[nodiscard]] bool symmetric_eigen(Eigen::MatrixXd& matrix, Eigen::VectorXd& values, bool with_vectors);

/// Eigenvalues and, if wanted, vectors of unit length of a general matrix. @return false if not converged
[[nodiscard]] bool general_eigen(Eigen::MatrixXd matrix, Eigen::VectorXcd& values, Eigen::MatrixXcd* vectors);
[[nodiscard]] bool general_eigen(Eigen::MatrixXcd matrix, Eigen::VectorXcd& values, Eigen::MatrixXcd* vectors);

}  // namespace trivet::numerics::lapack
