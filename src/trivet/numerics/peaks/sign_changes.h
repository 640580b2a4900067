// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

namespace trivet::numerics {

/// A place where a polynomial changes its sign.
struct SignChange {
  double at = 0;
  bool falling = false;    ///< from + to −
  double uncertainty = 0;  ///< half width of the interval in which round-off hides the sign
};

/// All sign changes of g(τ) = Σ coefficients[k] τᵏ for lower < τ < upper, ascending; |τ| may pass 1 by a little.
/// Complete by bisection: an interval is discarded only when bounds by Taylor's formula prove that it has no root, and
/// searched only when they prove that g is monotonic there. Below round-off of the coefficients no sign is claimed.
/// @throws foundation::NotComputable if a coefficient is not finite, or after 100,000 intervals
[[nodiscard]] std::vector<SignChange> sign_changes(std::span<const double> coefficients, double lower, double upper);

/// Σ coefficients[k] τᵏ.
[[nodiscard]] double polynomial_value(std::span<const double> coefficients, double tau);

}  // namespace trivet::numerics
