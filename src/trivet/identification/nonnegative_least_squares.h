// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::identification {

/// x ≥ 0 with least |A x − b|², by the active-set method of Lawson and Hanson (1974), whose end is the global minimum.
[[nodiscard]] Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace trivet::identification
