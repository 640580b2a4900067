// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sign_changes.h"

#include <algorithm>
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

class Search {
 public:
  Search(std::span<const double> g, std::vector<SignChange>& found) : g_(g), slope_(derivative(g)), bend_(derivative(slope_)), found_(found) {}

  void between(double lower, double upper) {
    const double middle = 0.5 * (lower + upper), half = 0.5 * (upper - lower);
    const double reach = std::max(std::abs(lower), std::abs(upper));
    const double value = polynomial_value(g_, middle), slope = polynomial_value(slope_, middle);
    const double bend = majorant(bend_, reach);
    const double noise = 8 * std::numeric_limits<double>::epsilon() * majorant(g_, reach);
    if (std::abs(value) > half * std::abs(slope) + 0.5 * half * half * bend + noise) {
      settle(lower, value > 0 ? 1 : -1);
    } else if (std::abs(slope) > half * bend && half * std::abs(slope) > 4 * noise) {
      settle(lower, sign(polynomial_value(g_, lower), noise));
      const int after = sign(polynomial_value(g_, upper), noise);
      if (sign_ != 0 && after != 0 && after != sign_) bisect(lower, upper, noise / std::abs(slope));
      else if (after == 0) return open(upper - half * 1e-3);
      settle(upper, after);
    } else if (std::abs(value) + half * std::abs(slope) + 0.5 * half * half * bend <= 4 * noise || half < 1e-13) {
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
  std::vector<double> slope_, bend_;
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
