// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/human_weighting.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "trivet/excitation/refusal.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::excitation {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double butterworth = std::numbers::sqrt2 / 2;

using Polynomial = std::vector<double>;

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial result(a.size() + b.size() - 1, 0);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  return result;
}

double angular(double hertz) { return 2 * std::numbers::pi * hertz; }

/// 1 + s/(Qω) + s²/ω², which is 1 for an infinite corner.
Polynomial second_order(double corner_hz, double q) {
  if (std::isinf(corner_hz)) return {1};
  const double omega = angular(corner_hz);
  return {1, 1 / (q * omega), 1 / (omega * omega)};
}

std::complex<double> value(const Polynomial& p, std::complex<double> s) {
  std::complex<double> sum = 0;
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * s + p[i];
  return sum;
}

}  // namespace

WeightingParameters parameters(Weighting weighting) {
  const double velocity_corner = 1 / (2 * std::numbers::pi * 0.028);  // a time constant of 28 ms
  switch (weighting) {
    case Weighting::Wb:
      return {0.4, 100, 16, 16, 0.55, 2.5, 0.9, 4, 0.95, 1.024};
    case Weighting::Wc:
      return {0.4, 100, 8, 8, 0.63, infinite, 1, infinite, 1, 1};
    case Weighting::Wd:
      return {0.4, 100, 2, 2, 0.63, infinite, 1, infinite, 1, 1};
    case Weighting::We:
      return {0.4, 100, 1, 1, 0.63, infinite, 1, infinite, 1, 1};
    case Weighting::Wf:
      return {0.08, 0.63, infinite, 0.25, 0.86, 0.0625, 0.8, 0.1, 0.8, 1};
    case Weighting::Wj:
      return {0.4, 100, infinite, infinite, 1, 3.75, 0.91, 5.32, 0.91, 1};
    case Weighting::Wk:
      return {0.4, 100, 12.5, 12.5, 0.63, 2.37, 0.91, 3.35, 0.91, 1};
    case Weighting::Wm:
      return {std::pow(10, -0.1), 100, velocity_corner, velocity_corner, 0.5, infinite, 1, infinite, 1, 1};
  }
  throw foundation::InvalidInput("unknown frequency weighting");
}

RationalTransfer rational_transfer(Weighting weighting) {
  const WeightingParameters p = parameters(weighting);
  const double w1 = angular(p.f1), step = std::isinf(p.f5) ? 1 : p.f5 / p.f6 * (p.f5 / p.f6);
  RationalTransfer h;
  h.numerator = {0, 0, p.gain * step / (w1 * w1)};
  if (!std::isinf(p.f3)) h.numerator = product(h.numerator, {1, 1 / angular(p.f3)});
  h.numerator = product(h.numerator, second_order(p.f5, p.q5));
  h.denominator = product(second_order(p.f1, butterworth), second_order(p.f2, butterworth));
  h.denominator = product(h.denominator, second_order(p.f4, p.q4));
  h.denominator = product(h.denominator, second_order(p.f6, p.q6));
  return h;
}

std::complex<double> transfer(Weighting weighting, double omega) {
  require_not_negative(omega, "angular frequency", "rad/s");
  const RationalTransfer h = rational_transfer(weighting);
  const std::complex<double> s(0, omega);
  return value(h.numerator, s) / value(h.denominator, s);
}

std::array<WeightedAxis, 6> comfort_axes(ContactPoint contact) {
  using enum Weighting;
  switch (contact) {
    case ContactPoint::seat_surface:
      return {{{Wd, 1}, {Wd, 1}, {Wk, 1}, {We, 0.63}, {We, 0.4}, {We, 0.2}}};
    case ContactPoint::backrest:
      return {{{Wc, 0.8}, {Wd, 0.5}, {Wd, 0.4}, {We, 0}, {We, 0}, {We, 0}}};
    case ContactPoint::feet:
      return {{{Wk, 0.25}, {Wk, 0.25}, {Wk, 0.4}, {We, 0}, {We, 0}, {We, 0}}};
    case ContactPoint::standing:
      return {{{Wd, 1}, {Wd, 1}, {Wk, 1}, {We, 0}, {We, 0}, {We, 0}}};
  }
  throw foundation::InvalidInput("unknown contact point");
}

std::array<WeightedAxis, 3> health_axes() { return {{{Weighting::Wd, 1.4}, {Weighting::Wd, 1.4}, {Weighting::Wk, 1}}}; }

double vibration_total_value(std::span<const double> accelerations, std::span<const double> factors) {
  if (accelerations.size() != factors.size())
    throw foundation::InvalidInput(fmt::format("{} accelerations and {} factors: each acceleration needs one factor",
                                               accelerations.size(), factors.size()));
  double sum = 0;
  for (std::size_t i = 0; i < accelerations.size(); ++i) sum += std::pow(factors[i] * accelerations[i], 2);
  return std::sqrt(sum);
}

}  // namespace trivet::excitation
