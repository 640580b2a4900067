// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/numerics/dynamic_matrices.h"
#include "trivet/numerics/load.h"

namespace trivet::numerics {

/// q(ω) = Z(ω)⁻¹ h(ω) for many ω, each with the backward error of its solution.
struct SweepResult {
  Eigen::MatrixXcd response;        ///< n × count; NaN where Z(ω) is singular
  Eigen::VectorXd backward_error;   ///< ‖Zq − h‖∞ / (‖Z‖∞ ‖q‖∞ + ‖h‖∞) in coordinates of unit mass diagonal
  int fallbacks = 0;                ///< frequencies redone by the pivoted solver
  int singular = 0;
};

/// Backward error above which a frequency is solved anew with pivoting.
inline constexpr double accepted_backward_error = 1e-14;

/// Symmetric matrices: LDLᵀ without pivoting on eight frequencies at a time, then residuals, then pivoted LU for the
/// frequencies that miss `accepted_backward_error`. Unsymmetric matrices: pivoted LU throughout.
[[nodiscard]] SweepResult sweep(const DynamicMatrices& matrices, const Load& load, const std::vector<double>& omega);

}  // namespace trivet::numerics
