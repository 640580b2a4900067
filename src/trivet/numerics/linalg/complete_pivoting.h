// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::numerics {

/// Is A regular by LU with complete pivoting: is its smallest pivot above round-off, or above `share` of the largest
/// one?
[[nodiscard]] bool is_regular(const Eigen::Matrix<double, 6, 6>& A);
[[nodiscard]] bool is_regular(const Eigen::MatrixXd& A, double share);

/// x of A x = b by LU with complete pivoting; one of the solutions, or the best one, if A is singular.
[[nodiscard]] Eigen::Matrix<double, 6, 1> completely_pivoted_solution(const Eigen::Matrix<double, 6, 6>& A,
                                                                      const Eigen::Matrix<double, 6, 1>& b);

/// A⁻¹ by LU with complete pivoting; without meaning unless A is regular.
[[nodiscard]] Eigen::Matrix<double, 6, 6> completely_pivoted_inverse(const Eigen::Matrix<double, 6, 6>& A);

}  // namespace trivet::numerics
