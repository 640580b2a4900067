// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/bouc_wen_branch.h"

#include <algorithm>
#include <cmath>

#include "trivet/numerics/periodic/gauss_nodes.h"

namespace trivet::elements {
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

}  // namespace trivet::elements
