// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>

namespace trivet::identification {

struct LeastSquaresMinimum {
  Eigen::VectorXd parameters;
  Eigen::VectorXd residuals;
  Eigen::MatrixXd unit_covariance;  ///< (JᵀJ)⁻¹; infinite diagonal if the data do not determine a parameter
  bool converged = false;
};

/// Local minimum of |residuals(parameters)|² by the Levenberg–Marquardt method with central differences for the
/// Jacobian; parameters should be of the order of 1. A start with residuals that are not finite does not converge.
[[nodiscard]] LeastSquaresMinimum least_squares_minimum(
    const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& residuals, const Eigen::VectorXd& start);

}  // namespace trivet::identification
