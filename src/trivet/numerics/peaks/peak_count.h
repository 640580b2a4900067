// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
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

/// Prominence of a peak: its height above the higher of the two minima that separate it from higher points or from an
/// end. `heights` begin and end with those at the ends of the curve. Infinite for an infinite height.
[[nodiscard]] double prominence(std::span<const double> heights, std::size_t peak);

/// Prominence of every point, in a time proportional to their number.
[[nodiscard]] std::vector<double> prominences(std::span<const double> heights);

struct PeakCount {
  int peaks = 0;
  double largest_rise = 0;                                   ///< largest value of height / (higher minimum) − 1
  double closest = std::numeric_limits<double>::infinity();  ///< smallest |prominence / least − 1|
};

/// Peaks with a prominence above `least`; infinite heights always count. `heights` as for `prominence`.
[[nodiscard]] PeakCount prominent_peaks(std::span<const double> heights, double least);

/// Whether the largest rise of the peaks with a prominence above `least` is known to `accuracy` (relative) if every
/// height may be wrong by its relative error in `doubts`.
/// @param largest_rise  as found by `prominent_peaks`
[[nodiscard]] bool rise_is_known(std::span<const double> heights, std::span<const double> doubts, double least,
                                 double largest_rise, double accuracy);

}  // namespace trivet::numerics
