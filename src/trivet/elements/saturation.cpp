// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/saturation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "trivet/numerics/periodic/gauss_nodes.h"

namespace trivet::elements {
namespace {

constexpr double by_series = 0.5;  // where wⁿ is at most this
constexpr int most_newton_steps = 60;

/// A polynomial by its values at Chebyshev's places.
template <std::size_t count>
std::array<double, count> polynomial_through(const std::array<double, count>& values) {
  std::array<double, count> found = {}, before = {}, wave = {};  // T_{j−1} and T_j by powers
  wave[0] = 1;
  for (std::size_t j = 0; j < count; ++j) {
    double coefficient = 0;
    for (std::size_t i = 0; i < count; ++i)
      coefficient += values[i] *
          std::cos(std::numbers::pi * static_cast<double>(j * (2 * i + 1)) / static_cast<double>(2 * count));
    coefficient *= (j == 0 ? 1.0 : 2.0) / static_cast<double>(count);
    for (std::size_t p = 0; p < count; ++p) found[p] += coefficient * wave[p];
    std::array<double, count> next = {};
    for (std::size_t p = 0; p < count; ++p)
      next[p] = (p > 0 ? (j == 0 ? 1.0 : 2.0) * wave[p - 1] : 0.0) - (j == 0 ? 0.0 : before[p]);
    before = wave;
    wave = next;
  }
  return found;
}

double chebyshev_place(std::size_t i, std::size_t count) {  // in (0, 1)
  return (1 + std::cos(std::numbers::pi * static_cast<double>(2 * i + 1) / static_cast<double>(2 * count))) / 2;
}

/// Two polynomials at x; even and odd powers apart, so that their sums do not wait for each other.
template <std::size_t count>
std::array<double, 2> at_both(const std::array<double, count>& a, const std::array<double, count>& b, double x) {
  static_assert(count % 2 == 0);
  const double square = x * x;
  double a_even = 0, a_odd = 0, b_even = 0, b_odd = 0;
  for (std::size_t p = count; p > 0; p -= 2) {
    a_even = a_even * square + a[p - 2];
    a_odd = a_odd * square + a[p - 1];
    b_even = b_even * square + b[p - 2];
    b_odd = b_odd * square + b[p - 1];
  }
  return {a_even + x * a_odd, b_even + x * b_odd};
}

}  // namespace

/// Both parts are analytic functions of their variables. w/s is singular next where w is infinite, at sⁿ =
/// −(π/n / sin π/n)ⁿ ≤ −1; (1 − w)/e at −e² for n = 2 and at −1 for n → ∞. So the coefficients of Chebyshev's
/// polynomials fall by 5.8 from one to the next.
Saturation::Saturation(double exponent) : n_(exponent) {
  Coefficients value, rate, missing, rate_over_missing;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const double place = chebyshev_place(i, value.size()), s = std::pow(place, 1 / n_);
    const double x = missing_at(s);
    value[i] = (1 - x) / s;
    rate[i] = -std::expm1(n_ * std::log1p(-x));
    const double beyond = missing_at(1 - std::log(place) / n_);
    missing[i] = beyond / place;
    rate_over_missing[i] = -std::expm1(n_ * std::log1p(-beyond)) / place;
  }
  value_ = polynomial_through(value);
  rate_ = polynomial_through(rate);
  missing_ = polynomial_through(missing);
  rate_over_missing_ = polynomial_through(rate_over_missing);
}

Saturation::Reached Saturation::at(double travel) const {
  if (travel <= 1) {
    const auto [value, rate] = at_both(value_, rate_, 2 * std::pow(travel, n_) - 1);
    return {travel * value, rate};
  }
  const double e = std::exp(n_ * (1 - travel));
  const auto [missing, rate] = at_both(missing_, rate_over_missing_, 2 * e - 1);
  return {1 - e * missing, e * rate};
}

double Saturation::travel(double value) const {
  const double power = std::pow(value, n_);
  if (power <= by_series) return series(value, power);
  constexpr double round_off = 1e-16;
  return near_limit(std::max(1 - value, round_off));
}

/// ∫ dw/(1 − wⁿ) by powers of wⁿ.
double Saturation::series(double value, double power) const {
  constexpr double smallest = 1e-17;
  double sum = 0, term = 1;
  for (int j = 0; term > smallest; ++j, term *= power) sum += term / (n_ * j + 1);
  return value * sum;
}

/// With w = 1 − x: ∫ dx/(1 − (1 − x)ⁿ), whose pole 1/(n x) is integrated exactly.
double Saturation::near_limit(double missing) const {
  const double middle = std::pow(by_series, 1 / n_), from = 1 - middle;
  double rest = 0;
  numerics::each_gauss_node(missing, from, 1, [&](double x, double weight) {
    rest += weight * (-1 / std::expm1(n_ * std::log1p(-x)) - 1 / (n_ * x));
  });
  return series(middle, by_series) + std::log(from / missing) / n_ + rest;
}

/// 1 − w at s, by Newton's method from the side on which each step falls short.
double Saturation::missing_at(double travel) const {
  const double middle = std::pow(by_series, 1 / n_), to_middle = series(middle, by_series);
  if (travel <= to_middle) {
    double value = std::min(travel, middle);
    for (int i = 0; i < most_newton_steps; ++i) {
      const double power = std::pow(value, n_), change = (travel - series(value, power)) * (1 - power);
      value += change;
      if (!(change < 0)) break;
    }
    return 1 - value;
  }
  double logarithm = std::log(1 - middle);
  for (int i = 0; i < most_newton_steps; ++i) {
    const double x = std::exp(logarithm), change = (near_limit(x) - travel) * -std::expm1(n_ * std::log1p(-x)) / x;
    logarithm += change;
    if (!(change < 0)) break;
  }
  return std::exp(logarithm);
}

std::shared_ptr<const Saturation> saturation(double exponent) {
  constexpr std::size_t kept = 8;
  thread_local std::array<std::shared_ptr<const Saturation>, kept> all;
  thread_local std::size_t oldest = 0;
  for (const auto& one : all)
    if (one && one->exponent() == exponent) return one;
  const std::size_t here = oldest;
  oldest = (oldest + 1) % kept;
  return all[here] = std::make_shared<const Saturation>(exponent);
}

}  // namespace trivet::elements
