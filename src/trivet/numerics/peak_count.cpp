// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/peak_count.h"

#include <algorithm>
#include <cmath>

namespace trivet::numerics {

double prominence(std::span<const double> heights, std::size_t peak) {
  const double height = heights[peak];
  if (std::isinf(height)) return height;
  double left = height, right = height;
  for (std::size_t k = peak; k-- > 0 && heights[k] <= height;) left = std::min(left, heights[k]);
  for (std::size_t k = peak + 1; k < heights.size() && heights[k] <= height; ++k) right = std::min(right, heights[k]);
  return height - std::max(left, right);
}

PeakCount prominent_peaks(std::span<const double> heights, double least) {
  PeakCount result;
  for (std::size_t i = 1; i + 1 < heights.size(); ++i) {
    const double height = heights[i];
    if (!(height > heights[i - 1] && height > heights[i + 1])) continue;
    const double above = prominence(heights, i);
    result.closest = std::min(result.closest, std::abs(above / least - 1));
    if (!(above > least)) continue;
    ++result.peaks;
    result.largest_rise = std::max(result.largest_rise, std::isinf(height) ? height : above / (height - above));
  }
  return result;
}

}  // namespace trivet::numerics
