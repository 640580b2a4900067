// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::study {

/// Squares ω² below this share of the largest may be round-off of a free motion, where matrices are sums or
/// interpolated: those agree with assembled ones to about 1e-12.
inline constexpr double free_motion_share = 1e-9;

/// May this ω² of a design be that of a free motion, which is no natural frequency? Only the assembled model can tell:
/// modal::modes compares ω² with the round-off of its stiffness.
[[nodiscard]] inline bool may_be_free(double squared, double largest) {
  return !(squared > free_motion_share * largest);
}

/// The same of any of the ω² of a design.
[[nodiscard]] inline bool any_may_be_free(const Eigen::ArrayXd& squares) {
  return squares.size() > 0 && (squares.isNaN().any() || may_be_free(squares.minCoeff(), squares.maxCoeff()));
}

}  // namespace trivet::study
