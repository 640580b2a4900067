// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/hysteretic_branch.h"

#include <algorithm>

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
