// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/peaks/sign_changes.h"

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

}  // namespace trivet::numerics
