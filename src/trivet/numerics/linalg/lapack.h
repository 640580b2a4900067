// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

/// Eigenproblems of many coordinates by LAPACK, if the library was built with it: blocked algorithms that take a tenth
/// of the time of Eigen's (docs/decisions/lapack.md).
namespace trivet::numerics::lapack {

/// Size from which LAPACK is faster than Eigen, measured.
inline constexpr Eigen::Index worth_it = 60;

[[nodiscard]] bool is_available();

/// Eigenvalues, ascending, and orthonormal vectors in place of the symmetric matrix. @return false if not converged
[[nodiscard]] bool symmetric_eigen(Eigen::MatrixXd& matrix, Eigen::VectorXd& values, bool with_vectors);

/// Eigenvalues and, if wanted, vectors of unit length of a general matrix. @return false if not converged
[[nodiscard]] bool general_eigen(Eigen::MatrixXd matrix, Eigen::VectorXcd& values, Eigen::MatrixXcd* vectors);
[[nodiscard]] bool general_eigen(Eigen::MatrixXcd matrix, Eigen::VectorXcd& values, Eigen::MatrixXcd* vectors);

}  // namespace trivet::numerics::lapack
