// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::numerics {

/// x ≥ 0 with the least |A x − b|, by the active-set method of Lawson and Hanson (Solving Least Squares Problems, 1974,
/// chapter 23). Most components of a strongly correlated A are exactly zero. For up to some hundreds of columns, or
/// thousands of which few are needed.
/// @param enough  stops as soon as |A x − b| ≤ enough; 0: at the minimum
[[nodiscard]] Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b,
                                                        double enough = 0);

}  // namespace trivet::numerics
