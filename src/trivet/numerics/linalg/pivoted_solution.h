// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>

namespace trivet::numerics {

/// Share of the norm below which a pivot is only round-off.
constexpr double negligible_pivot(int n) { return 16 * n * std::numeric_limits<double>::epsilon(); }

/// Solution of Z x = h by LU with partial pivoting and one step of refinement.
struct PivotedSolution {
  Eigen::VectorXcd x;         ///< NaN if Z is singular
  double backward_error = 0;  ///< ‖Zx − h‖∞ / (‖Z‖∞ ‖x‖∞ + ‖h‖∞); NaN if Z is singular
  double condition = 0;       ///< condition number of Z, estimated, if requested; infinite if Z is singular
};

/// @param Z  scaled so that its rows and columns are comparable in size
[[nodiscard]] PivotedSolution pivoted_solution(const Eigen::MatrixXcd& Z, const Eigen::VectorXcd& h,
                                               bool with_condition = false);

}  // namespace trivet::numerics
