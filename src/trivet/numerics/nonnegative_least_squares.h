// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::numerics {

/// x ≥ 0 with the least |A x − b|, by the active-set method of Lawson and Hanson (Solving Least Squares Problems, 1974, chapter 23).
/// Most components of a strongly correlated A come out exactly zero. Meant for up to some hundreds of columns.
[[nodiscard]] Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace trivet::numerics
