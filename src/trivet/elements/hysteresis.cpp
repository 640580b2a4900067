// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/hysteresis.h"

#include <algorithm>
#include <cmath>

#include "trivet/numerics/periodic/gauss_nodes.h"

namespace trivet::elements {
namespace {

// A travel downwards from f_0 is the mirror image of one upwards from −f_0; all laws are odd but for an asymmetry,
// which changes its sign in the image.

ForceOnTravel upwards(const Slider& law, double start, double travel) {
  constexpr double round_off = 1e-13;  // a loop that just reaches the limit slips there
  const double stuck = start + law.stiffness * travel;
  if (stuck >= law.limit() * (1 - round_off)) return {law.slip, 0, 0};
  return {stuck, law.stiffness, 1};
}

ForceOnTravel upwards(const CoulombFriction& law, double start, double travel) {
  if (travel == 0) return {start, 0, 1};
  return {law.slip, 0, 0};
}

ForceOnTravel upwards(const BergFriction& law, double start, double travel) {
  const double missing = 1 - start / law.force, reach = law.deflection * missing, sum = reach + travel;
  if (!(sum > 0)) return {law.force, 0, 0};
  const double share = travel / sum;
  return {start + share * law.force * missing, law.force * missing * reach / (sum * sum), 1 - share * share};
}

/// The travel ∫ dx/(1 − c x^n) from 0 to z, in units of F/k. c may have either sign; c z^n < 1.
class BoucWenTravel {
 public:
  BoucWenTravel(double c, double n) : c_(c), n_(n) {}

  [[nodiscard]] double rate(double z) const { return 1 - ratio(z); }
  [[nodiscard]] double ratio(double z) const { return c_ * std::pow(z, n_); }
  [[nodiscard]] double exponent() const { return n_; }
  [[nodiscard]] bool saturates() const { return c_ > 0; }

  [[nodiscard]] double operator()(double z) const { return at(z, ratio(z)); }
  /// @param ratio  c z^n
  [[nodiscard]] double at(double z, double ratio) const {
    constexpr double by_series = 0.5;
    if (std::abs(ratio) <= by_series) return series(z, ratio);
    const double middle = z * std::pow(by_series / std::abs(ratio), 1 / n_);
    return series(middle, ratio > 0 ? by_series : -by_series) +
        (c_ > 0 ? near_limit(middle, z) : integrated(middle, z));
  }

 private:
  [[nodiscard]] double series(double z, double ratio) const {
    constexpr double smallest = 1e-17;
    double sum = 0, power = 1;
    for (int j = 0; std::abs(power) > smallest; ++j, power *= ratio) sum += power / (n_ * j + 1);
    return z * sum;
  }

  template <typename Integrand>
  static double gauss(double from, double to, const Integrand& integrand) {
    constexpr double longest = 0.5;  // the error of 8 nodes is below 1e-12
    double sum = 0;
    numerics::each_gauss_node(from, to, longest, [&](double at, double weight) { sum += weight * integrand(at); });
    return sum;
  }

  /// With z = z_max (1 − x): ∫ dx/(1 − (1 − x)^n), whose pole 1/(n x) is integrated exactly.
  [[nodiscard]] double near_limit(double from, double to) const {
    const double limit = std::pow(c_, -1 / n_);
    constexpr double least = 1e-16;
    const double x_from = std::max(least, 1 - from / limit), x_to = std::max(least, 1 - to / limit);
    const double rest =
        gauss(x_to, x_from, [this](double x) { return -1 / std::expm1(n_ * std::log1p(-x)) - 1 / (n_ * x); });
    return limit * (std::log(x_from / x_to) / n_ + rest);
  }

  /// In the logarithm of z.
  [[nodiscard]] double integrated(double from, double to) const {
    return gauss(std::log(from), std::log(to), [this](double x) { return std::exp(x) / rate(std::exp(x)); });
  }

  double c_, n_;
};

/// z ≥ 0 at a travel ≥ 0 from z = 0, by Halley's method inside a bracket.
double reached(const BoucWenTravel& travel_to, double travel, double limit) {
  constexpr double saturated = 45;  // what is missing falls by e^−n for each travel by the limit
  if (travel_to.saturates() && travel_to.exponent() * travel > saturated * limit) return limit;
  double low = 0, high = limit, z = limit * std::tanh(travel / limit);
  constexpr int most = 100;
  constexpr double near = 1e-6;  // the next step is of the size of its cube
  for (int i = 0; i < most && z > 0; ++i) {
    const double ratio = travel_to.ratio(z), rate = 1 - ratio, missing = travel - travel_to.at(z, ratio);
    (missing > 0 ? low : high) = z;
    const double newton = missing * rate, bend = travel_to.exponent() * ratio / (z * rate);  // of the travel over z
    const double halley = z + newton / (1 + newton * bend / 2);
    const double next = halley >= low && halley <= high ? halley : (low + high) / 2;
    const bool done = next == halley && std::abs(next - z) <= near * limit;
    z = next;
    if (done) break;
  }
  return z;
}

template <typename Odd>
Odd mirrored(const Odd& law) {
  return law;
}
double z_limit(const BoucWen& law) {  // upwards
  return std::pow(law.beta + law.gamma + 2 * law.asymmetry, -1 / law.exponent);
}
BoucWen mirrored(BoucWen law) {
  law.asymmetry = -law.asymmetry;
  return law;
}
double z_at(const BoucWen& law, double force) {
  return std::clamp(force / law.force, -z_limit(mirrored(law)), z_limit(law));
}
BoucWenTravel loading(const BoucWen& law) { return {law.beta + law.gamma + 2 * law.asymmetry, law.exponent}; }
BoucWenTravel unloading(const BoucWen& law) { return {law.gamma - law.beta, law.exponent}; }

ForceOnTravel upwards(const BoucWen& law, double start, double travel) {
  const BoucWenTravel falls = unloading(law), grows = loading(law);
  const double from = z_at(law, start), limit = z_limit(law), unit = law.force / law.stiffness;
  const double rate_at_start = from < 0 ? falls.rate(-from) : grows.rate(from);
  double left = travel / unit, z = 0, rate = 0;
  const double to_zero = from < 0 ? falls(-from) : 0;
  if (left < to_zero) {
    z = -reached(falls, to_zero - left, z_limit(mirrored(law)));
    rate = falls.rate(-z);
  } else {
    left += from < 0 ? -to_zero : grows(from);
    z = reached(grows, left, limit);
    rate = std::max(0.0, grows.rate(z));
  }
  constexpr double at_limit = 1e-14;
  return {law.force * z, law.stiffness * rate,
          rate_at_start > at_limit ? rate / rate_at_start : (travel > 0 ? 0.0 : 1.0)};
}

std::optional<double> kink_upwards(const Slider& law, double start) { return (law.limit() - start) / law.stiffness; }
std::optional<double> kink_upwards(const BergFriction&, double) { return std::nullopt; }
std::optional<double> kink_upwards(const CoulombFriction&, double) { return std::nullopt; }
std::optional<double> kink_upwards(const BoucWen& law, double start) {
  if (start >= 0) return std::nullopt;
  return unloading(law)(-z_at(law, start)) * law.force / law.stiffness;
}

}  // namespace

ForceOnTravel force_on_travel(const HystereticForce& law, double start, double travel) {
  return std::visit(
      [&](const auto& one) {
        const double sign = travel < 0 ? -1 : 1;
        ForceOnTravel found = upwards(sign < 0 ? mirrored(one) : one, sign * start, sign * travel);
        found.force *= sign;
        return found;
      },
      law);
}

std::optional<double> kink_travel(const HystereticForce& law, double start, double direction) {
  return std::visit(
      [&](const auto& one) {
        std::optional<double> found = kink_upwards(direction < 0 ? mirrored(one) : one, direction * start);
        if (found) *found *= direction;
        return found;
      },
      law);
}

ForceOnTravel virgin_force(const HystereticForce& law, double deflection) {
  if (jumps_at_turns(law)) return {};
  if (const auto* slider = std::get_if<Slider>(&law))
    return force_on_travel(Slider{slider->stiffness, slider->slip}, 0, deflection);
  return force_on_travel(law, 0, deflection);
}

std::vector<double> virgin_kinks(const HystereticForce& law) {
  const auto* slider = std::get_if<Slider>(&law);
  if (!slider) return {};
  const double slips_at = slider->slip / slider->stiffness;
  return {-slips_at, slips_at};
}

double jump_at_kink(const HystereticForce& law, double direction) {
  const auto* slider = std::get_if<Slider>(&law);
  return slider ? direction * (slider->slip - slider->limit()) : 0;
}

double jump_at_turn(const HystereticForce& law, double start, double direction) {
  const auto* friction = std::get_if<CoulombFriction>(&law);
  return friction ? direction * friction->slip - start : 0;
}

bool jumps_at_turns(const HystereticForce& law) { return std::holds_alternative<CoulombFriction>(law); }

bool is_piecewise_linear(const HystereticForce& law) {
  return std::holds_alternative<Slider>(law) || jumps_at_turns(law);
}

double initial_stiffness(const HystereticForce& law) {
  if (jumps_at_turns(law)) return 0;
  if (const auto* berg = std::get_if<BergFriction>(&law)) return berg->force / berg->deflection;
  if (const auto* slider = std::get_if<Slider>(&law)) return slider->stiffness;
  return std::get<BoucWen>(law).stiffness;
}

double force_limit(const HystereticForce& law) {
  if (const auto* berg = std::get_if<BergFriction>(&law)) return berg->force;
  if (const auto* slider = std::get_if<Slider>(&law)) return slider->limit();
  if (const auto* friction = std::get_if<CoulombFriction>(&law)) return friction->slip;
  const auto& smooth = std::get<BoucWen>(law);
  return smooth.force * std::max(z_limit(smooth), z_limit(mirrored(smooth)));
}

}  // namespace trivet::elements
