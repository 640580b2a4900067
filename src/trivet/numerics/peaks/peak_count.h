// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <span>

namespace trivet::numerics {

/// Height of a peak among the heights along a curve, its ends first and last, above the higher of the two minima that
/// part it from higher ground or from an end. Infinite for an infinite height.
[[nodiscard]] double prominence(std::span<const double> heights, std::size_t peak);

struct PeakCount {
  int peaks = 0;
  double largest_rise = 0;  ///< of these over the higher of those minima: height / minimum − 1
  double closest = std::numeric_limits<double>::infinity();  ///< how near a prominence comes to `least`: smallest
                                                             ///< |prominence / least − 1|
};

/// Peaks among the heights along a curve, its ends first and last, whose prominence exceeds `least`. Infinite heights
/// count always.
[[nodiscard]] PeakCount prominent_peaks(std::span<const double> heights, double least);

/// Whether the largest rise of the peaks whose prominence exceeds `least` is known to `accuracy` (relative), if every
/// height may be off by its share in `doubts`.
/// @param largest_rise  as `prominent_peaks` found it
[[nodiscard]] bool rise_is_known(std::span<const double> heights, std::span<const double> doubts, double least,
                                 double largest_rise, double accuracy);

}  // namespace trivet::numerics
