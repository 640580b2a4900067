// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/peak_count.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trivet::numerics {

PeakCount prominent_peaks(std::span<const double> heights, double least) {
  PeakCount result;
  for (std::size_t i = 1; i + 1 < heights.size(); ++i) {
    const double height = heights[i];
    if (!(height > heights[i - 1] && height > heights[i + 1])) continue;
    double left = height, right = height;
    for (std::size_t k = i; k-- > 0 && heights[k] <= height;) left = std::min(left, heights[k]);
    for (std::size_t k = i + 1; k < heights.size() && heights[k] <= height; ++k) right = std::min(right, heights[k]);
    const double prominence = std::isinf(height) ? std::numeric_limits<double>::infinity() : height - std::max(left, right);
    result.closest = std::min(result.closest, std::abs(prominence / least - 1));
    if (!(prominence > least)) continue;
    ++result.peaks;
    result.largest_rise = std::max(result.largest_rise, std::isinf(height) ? height : prominence / (height - prominence));
  }
  return result;
}

}  // namespace trivet::numerics
