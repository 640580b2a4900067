// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/hysteresis.h"

#include <algorithm>
#include <cmath>

#include "trivet/numerics/periodic/gauss_nodes.h"

namespace trivet::elements {

ForceOnTravel force_on_travel(const HystereticForce& law, double start, double travel) {
  return HystereticBranch(law, start, travel).at(travel);
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

namespace {

/// ∫ dx/(1 + c xⁿ) from 0 to z, c ≥ 0.
double travel_against(double c, double n, double z) {
  const double ratio = c * std::pow(z, n);
  constexpr double by_series = 0.5, smallest = 1e-17;
  const double longest = 0.5 / std::max(1.0, n / 5);  // the error of 8 nodes is below 1e-12
  const double there = ratio <= by_series ? z : z * std::pow(by_series / ratio, 1 / n);
  double sum = 0, power = 1;
  for (int j = 0; std::abs(power) > smallest; ++j, power *= -std::min(ratio, by_series)) sum += power / (n * j + 1);
  sum *= there;
  if (there < z)
    numerics::each_gauss_node(std::log(there), std::log(z), longest, [&](double logarithm, double weight) {
      const double x = std::exp(logarithm);
      sum += weight * x / (1 + c * std::pow(x, n));
    });
  return sum;
}

/// z ≥ 0 at a travel, by Halley's method inside a bracket.
double reached_against(double c, double n, double travel, double most_z) {
  double low = 0, high = most_z, z = std::min(travel, most_z);
  constexpr int most = 100;
  constexpr double near = 1e-6;  // the next step is of the size of its cube
  for (int i = 0; i < most && z > 0; ++i) {
    const double ratio = c * std::pow(z, n), rate = 1 + ratio, missing = travel - travel_against(c, n, z);
    (missing > 0 ? low : high) = z;
    const double newton = missing * rate, bend = -n * ratio / (z * rate);  // of the travel over z
    const double halley = z + newton / (1 + newton * bend / 2);
    const double next = halley >= low && halley <= high ? halley : (low + high) / 2;
    const bool done = next == halley && std::abs(next - z) <= near * most_z;
    z = next;
    if (done) break;
  }
  return z;
}

}  // namespace

double z_limit(const BoucWen& law) { return std::pow(law.beta + law.gamma + 2 * law.asymmetry, -1 / law.exponent); }

BoucWen mirrored(BoucWen law) {
  law.asymmetry = -law.asymmetry;
  return law;
}

BoucWenBranch::BoucWenBranch(const BoucWen& law, double start)
    : grows_(saturation(law.exponent)),
      stiffness_(law.stiffness),
      force_(law.force),
      exponent_(law.exponent),
      against_(law.beta - law.gamma),
      limit_(z_limit(law)),
      from_(std::clamp(start / law.force, -z_limit(mirrored(law)), limit_)) {
  if (from_ < 0) {
    rate_at_start_ = 1 + (against_ == 0 ? 0 : against_ * std::pow(-from_, exponent_));
    offset_ = against_ == 0 ? from_
        : against_ > 0      ? -travel_against(against_, exponent_, -from_)
                            : -limit_against() * grows_->travel(-from_ / limit_against());
  } else {
    rate_at_start_ = 1 - std::pow(from_ / limit_, exponent_);
    offset_ = limit_ * grows_->travel(from_ / limit_);
  }
}

double BoucWenBranch::limit_against() const { return std::pow(-against_, -1 / exponent_); }

ForceOnTravel BoucWenBranch::at(double travel) const {
  const double reached = offset_ + travel * stiffness_ / force_;  // since z = 0
  double z = reached, rate = 1;
  if (reached >= 0) {
    const Saturation::Reached found = grows_->at(reached / limit_);
    z = limit_ * found.value;
    rate = found.rate;
  } else if (against_ < 0) {
    const Saturation::Reached found = grows_->at(-reached / limit_against());
    z = -limit_against() * found.value;
    rate = found.rate;
  } else if (against_ > 0) {
    z = -reached_against(against_, exponent_, -reached, -from_);
    rate = 1 + against_ * std::pow(-z, exponent_);
  }
  constexpr double at_limit = 1e-14;
  return {force_ * z, stiffness_ * rate, rate_at_start_ > at_limit ? rate / rate_at_start_ : (travel > 0 ? 0.0 : 1.0)};
}

std::optional<double> BoucWenBranch::to_zero() const {
  if (from_ >= 0) return std::nullopt;
  return -offset_ * force_ / stiffness_;
}

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

ForceOnTravel upwards(const BoucWenBranch& branch, double, double travel) { return branch.at(travel); }

std::optional<double> kink_upwards(const Slider& law, double start) { return (law.limit() - start) / law.stiffness; }
std::optional<double> kink_upwards(const BergFriction&, double) { return std::nullopt; }
std::optional<double> kink_upwards(const CoulombFriction&, double) { return std::nullopt; }
std::optional<double> kink_upwards(const BoucWenBranch& branch, double) { return branch.to_zero(); }

template <typename Odd>
Odd branch_upwards(const Odd& law, bool, double) {
  return law;
}
BoucWenBranch branch_upwards(const BoucWen& law, bool downwards, double start) {
  return {downwards ? mirrored(law) : law, start};
}

}  // namespace

HystereticBranch::HystereticBranch(const HystereticForce& law, double start, double direction)
    : sign_(direction < 0 ? -1 : 1),
      start_(sign_ * start),
      upwards_(std::visit(
          [this](const auto& one) -> decltype(upwards_) { return branch_upwards(one, sign_ < 0, start_); }, law)) {}

ForceOnTravel HystereticBranch::at(double travel) const {
  const double along = sign_ * travel < 0 ? 0 : sign_ * travel;
  ForceOnTravel found = std::visit([&](const auto& one) { return upwards(one, start_, along); }, upwards_);
  found.force *= sign_;
  return found;
}

std::optional<double> HystereticBranch::kink() const {
  std::optional<double> found = std::visit([&](const auto& one) { return kink_upwards(one, start_); }, upwards_);
  if (found) *found *= sign_;
  return found;
}

}  // namespace trivet::elements
