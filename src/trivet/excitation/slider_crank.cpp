// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/slider_crank.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::excitation {
namespace {

constexpr double negligible = 1e-18;

void require_rod_ratio(double lambda) {
  if (!(lambda > 0 && lambda < 1))
    throw foundation::InvalidInput(
        fmt::format("rod ratio λ = {:.6g}: crank radius over length of the rod must be > 0 and < 1", lambda));
}

/// √(1 − λ² sin²φ) = α |1 + q e^{2iφ}|.
struct Factors {
  double alpha, q;
};

Factors factors(double lambda) {
  const double root = std::sqrt((1 - lambda) * (1 + lambda));
  return {(1 + root) / 2, lambda * lambda / ((1 + root) * (1 + root))};
}

/// Coefficient c_k of cos 2kφ, k ≥ 1, from both binomial series (1 + qz)^½ (1 + q/z)^½.
double root_coefficient(const Factors& f, int k) {
  double binomial = 1;  // C(½, j) q^j
  const auto next = [&f](double value, int j) { return value * f.q * (0.5 - j) / (j + 1); };
  double shifted = 1;
  for (int j = 0; j < k; ++j) shifted = next(shifted, j);
  double sum = 0;
  for (int j = 0; std::abs(binomial) > negligible; ++j) {
    sum += binomial * shifted;
    binomial = next(binomial, j);
    shifted = next(shifted, j + k);
  }
  return 2 * f.alpha * sum;
}

}  // namespace

int negligible_order(double lambda) {
  require_rod_ratio(lambda);
  return 2 * static_cast<int>(std::ceil(std::log(negligible) / std::log(factors(lambda).q))) + 2;
}

std::vector<double> inertia_coefficients(double lambda, int highest) {
  require_rod_ratio(lambda);
  if (highest < 1) throw foundation::InvalidInput(fmt::format("highest order {}: it must be ≥ 1", highest));
  std::vector<double> a(to_size(highest) + 1, 0);
  a[1] = 1;
  const Factors f = factors(lambda);
  for (int n = 2; n <= std::min(highest, negligible_order(lambda)); n += 2)
    a[n] = static_cast<double>(n) * n / lambda * root_coefficient(f, n / 2);
  return a;
}

std::vector<double> inertia_torque_coefficients(double lambda, int highest) {
  const int count = negligible_order(lambda);
  const std::vector<double> a = inertia_coefficients(lambda, count);
  std::vector<double> g(to_size(highest) + 1, 0);
  for (int m = 1; m <= count; ++m)
    for (int n = 1; n <= count; ++n) {
      const double share = 0.5 * a[m] / m * a[n];
      if (m + n <= highest) g[m + n] += share;
      if (const int difference = std::abs(m - n); difference <= highest && m != n)
        g[difference] += m > n ? share : -share;
    }
  return g;
}

}  // namespace trivet::excitation
