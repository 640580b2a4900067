// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

namespace trivet::numerics {

/// A sign change of a polynomial.
struct SignChange {
  double at = 0;
  bool falling = false;    ///< from + to −
  double uncertainty = 0;  ///< half width of the interval in which round-off hides the sign
};

/// All sign changes of g(τ) = Σ coefficients[k] τᵏ for lower < τ < upper, ascending; |τ| may slightly exceed 1.
/// Bisection misses none: an interval is discarded only if bounds by Taylor's formula prove that it has no root, and
/// searched only if they prove that g is monotonic there. Signs below the round-off of the coefficients count as
/// unknown.
/// @throws foundation::NotComputable if a coefficient is not finite, or after 100,000 intervals
[[nodiscard]] std::vector<SignChange> sign_changes(std::span<const double> coefficients, double lower, double upper);

/// Σ coefficients[k] τᵏ.
[[nodiscard]] double polynomial_value(std::span<const double> coefficients, double tau);

}  // namespace trivet::numerics
