// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/peaks/peak_count.h"

#include <algorithm>
#include <cmath>

namespace trivet::numerics {
namespace {

/// Minima between a peak and the next higher point or end on either side, the higher one first; the peak itself if a
/// side has none.
struct Minima {
  std::size_t base, lower;
};

Minima minima_of(std::span<const double> heights, std::size_t peak) {
  std::size_t left = peak, right = peak;
  for (std::size_t k = peak; k > 0 && heights[k - 1] <= heights[peak]; --k)
    if (heights[k - 1] < heights[left]) left = k - 1;
  for (std::size_t k = peak + 1; k < heights.size() && heights[k] <= heights[peak]; ++k)
    if (heights[k] < heights[right]) right = k;
  return heights[left] > heights[right] ? Minima{left, right} : Minima{right, left};
}

/// Minimum from the next higher point before each point up to it, in the order of `heights`.
template <typename Heights>
std::vector<double> minima_before(const Heights& heights) {
  struct Higher {
    double height, lowest;  // from the higher one before it
  };
  std::vector<Higher> higher;  // each lower than the one before it
  std::vector<double> lowest;
  for (const double height : heights) {
    Higher point{height, height};
    for (; !higher.empty() && higher.back().height <= height; higher.pop_back())
      point.lowest = std::min(point.lowest, higher.back().lowest);
    higher.push_back(point);
    lowest.push_back(point.lowest);
  }
  return lowest;
}

bool stands_out(std::span<const double> heights, std::size_t i) {
  return heights[i] > heights[i - 1] && heights[i] > heights[i + 1];
}

}  // namespace

double prominence(std::span<const double> heights, std::size_t peak) {
  return std::isinf(heights[peak]) ? heights[peak] : heights[peak] - heights[minima_of(heights, peak).base];
}

std::vector<double> prominences(std::span<const double> heights) {
  std::vector<double> result = minima_before(heights);
  const std::vector<double> after = minima_before(std::vector<double>(heights.rbegin(), heights.rend()));
  for (std::size_t i = 0; i < result.size(); ++i) {
    const double base = std::max(result[i], after[result.size() - 1 - i]);
    result[i] = std::isinf(heights[i]) ? heights[i] : heights[i] - base;
  }
  return result;
}

bool rise_is_known(std::span<const double> heights, std::span<const double> doubts, double least, double largest_rise,
                   double accuracy) {
  for (std::size_t i = 1; i + 1 < heights.size(); ++i) {
    if (!stands_out(heights, i) || std::isinf(heights[i])) continue;
    const auto [base, lower] = minima_of(heights, i);
    if (!(heights[i] - heights[base] > least)) continue;
    const bool exchange = heights[lower] * (1 + 2 * doubts[lower]) > heights[base] &&
        doubts[lower] > accuracy;  // the lower one may be the higher
    const auto hidden = [&](std::size_t k) { return heights[k] == 0 && doubts[k] > 0; };  // by round-off
    if (exchange || hidden(base) || hidden(lower)) return false;
    const double ratio = heights[i] / heights[base], doubt = doubts[i] + doubts[base];
    if (doubt > 0 && !(ratio * doubt <= accuracy * largest_rise || ratio * (1 + 2 * doubt) < 1 + largest_rise))
      return false;
  }
  return true;
}

PeakCount prominent_peaks(std::span<const double> heights, double least) {
  PeakCount result;
  for (std::size_t i = 1; i + 1 < heights.size(); ++i) {
    const double height = heights[i];
    if (!stands_out(heights, i)) continue;
    const double above = prominence(heights, i);
    result.closest = std::min(result.closest, std::abs(above / least - 1));
    if (!(above > least)) continue;
    ++result.peaks;
    result.largest_rise = std::max(result.largest_rise, std::isinf(height) ? height : above / (height - above));
  }
  return result;
}

}  // namespace trivet::numerics
