// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/peaks/peak_count.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/foundation/invalid_input.h"

namespace trivet::numerics {

namespace {

/// g and its first derivatives at a point, divided by 1!, 2!, 3!; for |τ| ≤ reach, bounds on the remainder of the
/// Taylor series and on round-off.
struct Local {
  double g = 0, first = 0, second = 0, third = 0;
  double fourth = 0;  ///< bound on the fourth derivative / 4!
  double noise = 0;
};

/// Horner's scheme for all derivatives at once: each update uses only values of the previous step.
Local local_expansion(std::span<const double> c, double at, double reach) {
  Local d;
  double most = 0, most_first = 0, most_second = 0, most_third = 0;
  for (std::size_t k = c.size(); k-- > 0;) {
    d.third = d.third * at + d.second;
    d.second = d.second * at + d.first;
    d.first = d.first * at + d.g;
    d.g = d.g * at + c[k];
    d.fourth = d.fourth * reach + most_third;
    most_third = most_third * reach + most_second;
    most_second = most_second * reach + most_first;
    most_first = most_first * reach + most;
    most = most * reach + std::abs(c[k]);
  }
  d.noise = 8 * std::numeric_limits<double>::epsilon() * most;
  return d;
}

/// A search that ends needs a tenth of this: some 70 roots, two intervals per halving, at most 45 halvings.
constexpr int most_intervals = 100'000;

class Search {
 public:
  Search(std::span<const double> g, std::vector<SignChange>& found) : g_(g), found_(found) {}

  void between(double lower, double upper) {
    if (++intervals_ > most_intervals)
      throw foundation::NotComputable(
          "the extrema of a curve were not found: its slope changes sign too often for the search");
    const double middle = 0.5 * (lower + upper), half = 0.5 * (upper - lower);
    const Local d = local_expansion(g_, middle, std::max(std::abs(lower), std::abs(upper)));
    // Bounds on |g − g(middle)| and |g' − g'(middle)| on the interval, by Taylor's formula.
    const double second = std::abs(d.second), third = std::abs(d.third);
    const double change = half * (std::abs(d.first) + half * (second + half * (third + half * d.fourth)));
    const double change_of_slope = half * (2 * second + half * (3 * third + half * 4 * d.fourth));
    if (std::abs(d.g) > change + d.noise) {
      set_sign(lower, d.g > 0 ? 1 : -1);
    } else if (std::abs(d.first) > change_of_slope && half * std::abs(d.first) > 4 * d.noise) {
      set_sign(lower, sign(polynomial_value(g_, lower), d.noise));
      const int after = sign(polynomial_value(g_, upper), d.noise);
      if (after == 0) return open(upper - half * 1e-3);
      if (sign_ != 0 && after != sign_) close_in(lower, upper, middle - d.g / d.first, d.noise / std::abs(d.first));
      set_sign(upper, after);
    } else if (std::abs(d.g) + change <= 4 * d.noise || half < 1e-13) {
      open(lower);
    } else {
      between(lower, middle);
      between(middle, upper);
    }
  }

 private:
  static int sign(double value, double noise) { return value > noise ? 1 : value < -noise ? -1 : 0; }

  /// The sign is known again from `from` on; if it differs from the last known one, it changed in the unclear interval.
  void set_sign(double from, int now) {
    if (now == 0) return open(from);
    if (sign_ != 0 && now != sign_) {
      const double since = unclear_ ? unclear_since_ : from;
      found_.push_back({0.5 * (since + from), now < 0, 0.5 * (from - since)});
    }
    sign_ = now;
    unclear_ = false;
  }

  void open(double from) {
    if (!unclear_) unclear_since_ = from;
    unclear_ = true;
  }

  /// Newton's method where g is monotonic; a step that leaves the bracket of the zero is replaced by bisection.
  void close_in(double lower, double upper, double at, double uncertainty) {
    constexpr int most_steps = 80;
    const bool falling = sign_ > 0;
    for (int i = 0; i < most_steps; ++i) {
      if (!(at > lower && at < upper)) at = 0.5 * (lower + upper);
      double g = 0, slope = 0;
      for (std::size_t k = g_.size(); k-- > 0;) {
        slope = slope * at + g;
        g = g * at + g_[k];
      }
      ((g > 0) == falling ? lower : upper) = at;
      const double next = at - g / slope;
      if (!(std::abs(next - at) > std::numeric_limits<double>::epsilon() * std::abs(at))) break;
      at = next;
    }
    found_.push_back({at, falling, uncertainty});
    sign_ = falling ? -1 : 1;
    unclear_ = false;
  }

  std::span<const double> g_;
  std::vector<SignChange>& found_;
  int sign_ = 0;
  bool unclear_ = false;
  double unclear_since_ = 0;
  int intervals_ = 0;
};

}  // namespace

double polynomial_value(std::span<const double> c, double tau) {
  double value = 0;
  for (std::size_t k = c.size(); k-- > 0;) value = value * tau + c[k];
  return value;
}

std::vector<SignChange> sign_changes(std::span<const double> coefficients, double lower, double upper) {
  std::vector<SignChange> found;
  if (!std::ranges::all_of(coefficients, [](double c) { return std::isfinite(c); }))
    throw foundation::NotComputable(
        "the extrema of a curve were not found: its series contains numbers beyond the range of computation");
  if (coefficients.size() > 1) Search(coefficients, found).between(lower, upper);
  return found;
}

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
