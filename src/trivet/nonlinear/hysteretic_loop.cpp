// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/hysteretic_loop.h"

#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/periodic/fourier_basis.h"
#include "trivet/numerics/periodic/level_crossings.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::VectorXd;
using elements::ForceOnTravel;
using foundation::two_pi;

HystereticLoop::HystereticLoop(const LawAbout::Hysteretic& part, const VectorXd& deflection,
                               const std::vector<double>& turns, double turning_slope)
    : part_(part), turning_slope_(turning_slope) {
  if (turns.empty()) return;
  const Index harmonics = (deflection.size() - 1) / 2;
  for (std::size_t i = 0; i < turns.size(); ++i)
    branches_.push_back({turns[i],
                         i + 1 < turns.size() ? turns[i + 1] : turns.front() + two_pi,
                         numerics::motion_at(harmonics, turns[i], deflection),
                         0,
                         0,
                         {},
                         std::nullopt,
                         0});
  const double start = elements::force_on_travel(part_.law, part_.at_state, branches_.front().deflection).force;
  sticks_ = std::holds_alternative<elements::Slider>(part_.law) && around(start).by_start == 1;
  around(sticks_ ? start : closed(start));
  set_slopes(deflection);
  for (std::size_t i = 0; i < branches_.size(); ++i) {
    Branch& branch = branches_[i];
    const double travel = branches_[(i + 1) % branches_.size()].deflection - branch.deflection;
    const double direction = travel < 0 ? -1 : 1;
    branch.jump = elements::jump_at_turn(part_.law, branch.force, direction);
    const std::optional<double> kink = elements::kink_travel(part_.law, branch.force, direction);
    if (!kink || !(std::abs(*kink) > 0) || std::abs(*kink) >= std::abs(travel)) continue;
    branch.kink = numerics::crossing_between(deflection, branch.deflection + *kink, branch.from, branch.to);
    branch.kink_jump = elements::jump_at_kink(part_.law, direction);
  }
}

std::vector<HystereticLoop::Jump> HystereticLoop::jumps(const VectorXd& deflection) const {
  const Index harmonics = (deflection.size() - 1) / 2;
  const VectorXd slope = numerics::phase_derivative(deflection);
  std::vector<Jump> found;
  for (std::size_t b = 0; b < branches_.size(); ++b) {
    const Branch& branch = branches_[b];
    if (branch.jump != 0) {
      const double curvature = numerics::motion_at(harmonics, branch.from, numerics::phase_derivative(slope));
      const double slope = branch.jump < 0 ? turning_slope_ : -turning_slope_;  // falls with ω²
      found.push_back({branch.from, branch.jump, b, 0, -1 / curvature, 0, -2 * slope / curvature});
    }
    if (branch.kink_jump == 0) continue;
    const double there = numerics::motion_at(harmonics, *branch.kink, slope);
    found.push_back(
        {*branch.kink, branch.kink_jump, b, -1 / there, 0, -1 / (elements::initial_stiffness(part_.law) * there), 0});
  }
  return found;
}

bool HystereticLoop::is_symmetric() const {
  if (branches_.size() != 2 || elements::is_piecewise_linear(part_.law)) return false;
  const auto* smooth = std::get_if<elements::BoucWen>(&part_.law);
  return !smooth || smooth->asymmetry == 0;
}

ForceOnTravel HystereticLoop::around(double start) {
  double force = start, by_start = 1;
  for (std::size_t i = 0; i < branches_.size(); ++i) {
    branches_[i].force = force;
    const double travel = branches_[(i + 1) % branches_.size()].deflection - branches_[i].deflection;
    const ForceOnTravel next = elements::force_on_travel(part_.law, force, travel);
    force = next.force;
    by_start *= next.by_start;
  }
  return {force, 0, by_start};
}

double HystereticLoop::closed(double force) {
  constexpr int most = 60;
  constexpr double accurate = 1e-15, round_off = 1e-13;
  const double limit = elements::force_limit(part_.law);
  if (is_symmetric()) {
    const double travel = branches_[1].deflection - branches_[0].deflection;
    for (int i = 0; i < most; ++i) {
      const ForceOnTravel end = elements::force_on_travel(part_.law, force, travel);
      const double change = -(end.force + force) / (end.by_start + 1);
      force += change;
      if (std::abs(change) <= accurate * limit) break;
    }
    return force;
  }
  for (int i = 0; i < most; ++i) {
    const ForceOnTravel after = around(force);
    const double missing = after.force - force;
    if (std::abs(missing) <= accurate * limit) break;
    force += after.by_start < 1 - round_off ? missing / (1 - after.by_start) : missing;
  }
  return force;
}

void HystereticLoop::set_slopes(const VectorXd& deflection) {
  const Index harmonics = (deflection.size() - 1) / 2;
  const auto row = [&](std::size_t i) {
    return VectorXd(numerics::fourier_row(harmonics, branches_[i % branches_.size()].from).transpose());
  };
  const std::size_t count = branches_.size();
  std::vector<ForceOnTravel> ends;
  for (std::size_t i = 0; i < count; ++i)
    ends.push_back(elements::force_on_travel(part_.law, branches_[i].force,
                                             branches_[(i + 1) % count].deflection - branches_[i].deflection));
  if (sticks_) {
    branches_.front().force_slopes = elements::initial_stiffness(part_.law) * row(0);
  } else if (is_symmetric()) {
    branches_.front().force_slopes = -ends[0].by_travel / (1 + ends[0].by_start) * (row(1) - row(0));
  } else {
    VectorXd slopes = VectorXd::Zero(deflection.size());
    double by_start = 1;
    for (std::size_t i = 0; i < count; ++i) {
      slopes = ends[i].by_travel * (row(i + 1) - row(i)) + ends[i].by_start * slopes;
      by_start *= ends[i].by_start;
    }
    branches_.front().force_slopes = slopes / (1 - by_start);
  }
  for (std::size_t i = 0; i + 1 < count; ++i)
    branches_[i + 1].force_slopes =
        ends[i].by_travel * (row(i + 1) - row(i)) + ends[i].by_start * branches_[i].force_slopes;
}

const HystereticLoop::Branch& HystereticLoop::branch_at(double phase) const {
  if (phase < branches_.front().from) phase += two_pi;
  std::size_t i = branches_.size() - 1;
  while (i > 0 && branches_[i].from > phase) --i;
  return branches_[i];
}

ForceOnTravel HystereticLoop::at(const Branch& branch, double deflection) const {
  // Friction without a spring turns a little before the given harmonics do.
  if (branch.jump != 0) return {branch.force + branch.jump - part_.at_state, 0, 0};
  ForceOnTravel found = elements::force_on_travel(part_.law, branch.force, deflection - branch.deflection);
  found.force -= part_.at_state;
  return found;
}

}  // namespace trivet::nonlinear
