// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sign_changes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace trivet::numerics {
namespace {

std::vector<double> derivative(std::span<const double> c) {
  std::vector<double> d;
  for (std::size_t k = 1; k < c.size(); ++k) d.push_back(static_cast<double>(k) * c[k]);
  return d;
}

/// Σ |c_k| rᵏ: no value of the polynomial on |τ| ≤ r is larger.
double majorant(std::span<const double> c, double r) {
  double sum = 0;
  for (std::size_t k = c.size(); k-- > 0;) sum = sum * r + std::abs(c[k]);
  return sum;
}

/// Derivatives that enter a bound by their value in the middle of an interval; the next one enters by its majorant.
constexpr std::size_t local_orders = 4;

class Search {
 public:
  Search(std::span<const double> g, std::vector<SignChange>& found) : g_(g), found_(found) {
    derivatives_.emplace_back(g.begin(), g.end());
    while (derivatives_.size() <= local_orders) derivatives_.push_back(derivative(derivatives_.back()));
  }

  void between(double lower, double upper) {
    const double middle = 0.5 * (lower + upper), half = 0.5 * (upper - lower);
    const double reach = std::max(std::abs(lower), std::abs(upper));
    const double noise = 8 * std::numeric_limits<double>::epsilon() * majorant(g_, reach);
    std::array<double, local_orders + 1> d{};
    for (std::size_t k = 0; k < local_orders; ++k) d[k] = polynomial_value(derivatives_[k], middle);
    d[local_orders] = majorant(derivatives_[local_orders], reach);
    // |g − g(middle)| and |g' − g'(middle)| on the interval, by Taylor's formula.
    const double change = half * (std::abs(d[1]) + half / 2 * (std::abs(d[2]) + half / 3 * (std::abs(d[3]) + half / 4 * d[4])));
    const double change_of_slope = half * (std::abs(d[2]) + half / 2 * (std::abs(d[3]) + half / 3 * d[4]));
    if (std::abs(d[0]) > change + noise) {
      settle(lower, d[0] > 0 ? 1 : -1);
    } else if (std::abs(d[1]) > change_of_slope && half * std::abs(d[1]) > 4 * noise) {
      settle(lower, sign(polynomial_value(g_, lower), noise));
      const int after = sign(polynomial_value(g_, upper), noise);
      if (after == 0) return open(upper - half * 1e-3);
      if (sign_ != 0 && after != sign_) bisect(lower, upper, noise / std::abs(d[1]));
      settle(upper, after);
    } else if (std::abs(d[0]) + change <= 4 * noise || half < 1e-13) {
      open(lower);
    } else {
      between(lower, middle);
      between(middle, upper);
    }
  }

 private:
  static int sign(double value, double noise) { return value > noise ? 1 : value < -noise ? -1 : 0; }

  /// From `from` on the sign is known again; if it differs from the last known one, it changed in the unclear part between.
  void settle(double from, int now) {
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

  void bisect(double lower, double upper, double uncertainty) {
    const bool falling = sign_ > 0;
    double a = lower, b = upper;
    for (int i = 0; i < 80 && b - a > 0; ++i) {
      const double middle = 0.5 * (a + b);
      if (middle == a || middle == b) break;
      ((polynomial_value(g_, middle) > 0) == falling ? a : b) = middle;
    }
    found_.push_back({0.5 * (a + b), falling, uncertainty});
    sign_ = falling ? -1 : 1;
    unclear_ = false;
  }

  std::span<const double> g_;
  std::vector<std::vector<double>> derivatives_;
  std::vector<SignChange>& found_;
  int sign_ = 0;
  bool unclear_ = false;
  double unclear_since_ = 0;
};

}  // namespace

double polynomial_value(std::span<const double> c, double tau) {
  double value = 0;
  for (std::size_t k = c.size(); k-- > 0;) value = value * tau + c[k];
  return value;
}

std::vector<SignChange> sign_changes(std::span<const double> coefficients, double lower, double upper) {
  std::vector<SignChange> found;
  if (coefficients.size() > 1) Search(coefficients, found).between(lower, upper);
  return found;
}

}  // namespace trivet::numerics
