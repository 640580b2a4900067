// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::numerics {

/// Whether A is regular: by LU with complete pivoting, its smallest pivot exceeds round-off, or `share` of the largest
/// pivot.
[[nodiscard]] bool is_regular(const Eigen::Matrix<double, 6, 6>& A);
[[nodiscard]] bool is_regular(const Eigen::MatrixXd& A, double share);

/// Solution x of A x = b by LU with complete pivoting; if A is singular, one of the solutions or the best
/// approximation.
[[nodiscard]] Eigen::Matrix<double, 6, 1> completely_pivoted_solution(const Eigen::Matrix<double, 6, 6>& A,
                                                                      const Eigen::Matrix<double, 6, 1>& b);

/// A⁻¹ by LU with complete pivoting; meaningless unless A is regular.
[[nodiscard]] Eigen::Matrix<double, 6, 6> completely_pivoted_inverse(const Eigen::Matrix<double, 6, 6>& A);

}  // namespace trivet::numerics
