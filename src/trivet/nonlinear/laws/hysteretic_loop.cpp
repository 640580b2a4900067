// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/law_over_period.h"

#include <cassert>
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

HystereticLoop::HystereticLoop(const DeviationLaw::Hysteretic& part, const VectorXd& deflection,
                               const std::vector<double>& turns, double turning_slope)
    : part_(part), turning_slope_(turning_slope) {
  if (turns.empty()) return;
  assert(std::ranges::is_sorted(turns) && turns.front() >= 0 && turns.back() <= two_pi);
  const Index harmonics = (deflection.size() - 1) / 2;
  for (std::size_t i = 0; i < turns.size(); ++i)
    branches_.push_back({turns[i], i + 1 < turns.size() ? turns[i + 1] : turns.front() + two_pi,
                         numerics::motion_at(harmonics, turns[i], deflection)});
  const ForceOnTravel first = elements::force_on_travel(part_.law, part_.at_state, branches_.front().deflection);
  const double start = closed(first.force);
  sticks_ = std::holds_alternative<elements::Slider>(part_.law) && around(start).by_start == 1;
  around(start);
  if (sticks_) set_slopes_of_sticking(first, deflection);
  else set_slopes(deflection);
  for (std::size_t i = 0; i < branches_.size(); ++i) {
    Branch& branch = branches_[i];
    const double travel = branches_[(i + 1) % branches_.size()].deflection - branch.deflection;
    const double direction = travel < 0 ? -1 : 1;
    branch.jump = elements::jump_at_turn(part_.law, branch.force, direction);
    branch.course.emplace(part_.law, branch.force, direction);
    const std::optional<double> kink = branch.course->kink();
    if (!kink || !(std::abs(*kink) > 0) || std::abs(*kink) >= std::abs(travel)) continue;
    branch.kink = numerics::crossing_between(deflection, branch.deflection + *kink, branch.from, branch.to);
    branch.kink_jump = elements::jump_at_kink(part_.law, direction);
  }
}

std::vector<HystereticLoop::Jump> HystereticLoop::jumps(const VectorXd& deflection) const {
  const Index harmonics = (deflection.size() - 1) / 2;
  const VectorXd rate = numerics::phase_derivative(deflection);
  std::vector<Jump> found;
  for (std::size_t b = 0; b < branches_.size(); ++b) {
    const Branch& branch = branches_[b];
    if (branch.jump != 0) {
      const double curvature = numerics::motion_at(harmonics, branch.from, numerics::phase_derivative(rate));
      const double slope = branch.jump < 0 ? turning_slope_ : -turning_slope_;  // falls with ω²
      found.push_back({branch.from, branch.jump, b, 0, -1 / curvature, 0, -2 * slope / curvature});
    }
    if (branch.kink_jump == 0) continue;
    const double there = numerics::motion_at(harmonics, *branch.kink, rate);
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
  // Newton's method on f(2π; f₀) − f₀ = 0, or on f(second turning point; f₀) + f₀ = 0 of a symmetric loop.
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

std::vector<ForceOnTravel> HystereticLoop::ends() const {
  const std::size_t count = branches_.size();
  std::vector<ForceOnTravel> found;
  for (std::size_t i = 0; i < count; ++i)
    found.push_back(elements::force_on_travel(part_.law, branches_[i].force,
                                              branches_[(i + 1) % count].deflection - branches_[i].deflection));
  return found;
}

VectorXd HystereticLoop::row_at_turn(std::size_t turn, const VectorXd& deflection) const {
  return numerics::fourier_row((deflection.size() - 1) / 2, branches_[turn % branches_.size()].from).transpose();
}

VectorXd HystereticLoop::slopes_after(std::size_t branch, const ForceOnTravel& end, const VectorXd& slopes,
                                      const VectorXd& deflection) const {
  return end.by_travel * (row_at_turn(branch + 1, deflection) - row_at_turn(branch, deflection)) +
      end.by_start * slopes;
}

void HystereticLoop::set_slopes(const VectorXd& deflection) {
  const std::vector<ForceOnTravel> end = ends();
  if (is_symmetric()) {
    branches_.front().force_slopes =
        -end[0].by_travel / (1 + end[0].by_start) * (row_at_turn(1, deflection) - row_at_turn(0, deflection));
  } else {
    VectorXd slopes = VectorXd::Zero(deflection.size());
    double by_start = 1;
    for (std::size_t i = 0; i < branches_.size(); ++i) {
      slopes = slopes_after(i, end[i], slopes, deflection);
      by_start *= end[i].by_start;
    }
    // δf(2π) = by_start δf₀ + slopes δ: closed for δf₀ = slopes δ/(1 − by_start).
    assert(by_start != 1 && "a loop that does not stick forgets");
    branches_.front().force_slopes = slopes / (1 - by_start);
  }
  for (std::size_t i = 0; i + 1 < branches_.size(); ++i)
    branches_[i + 1].force_slopes = slopes_after(i, end[i], branches_[i].force_slopes, deflection);
}

/// A slider that sticks has the force at which it came to stick: of the way from the state to the first turning point,
/// and of the periods in which it slipped.
void HystereticLoop::set_slopes_of_sticking(const ForceOnTravel& first, const VectorXd& deflection) {
  const double force = branches_.front().force;
  VectorXd slopes = first.by_travel * row_at_turn(0, deflection);
  constexpr int most = 60;
  double start = first.force;
  for (int period = 0; period < most && start != force; ++period) {
    const double after = around(start).force;
    const std::vector<ForceOnTravel> end = ends();
    for (std::size_t i = 0; i < branches_.size(); ++i) slopes = slopes_after(i, end[i], slopes, deflection);
    start = after;
  }
  around(force);
  const std::vector<ForceOnTravel> end = ends();
  for (std::size_t i = 0; i < branches_.size(); ++i) {
    branches_[i].force_slopes = slopes;
    slopes = slopes_after(i, end[i], slopes, deflection);
  }
}

bool HystereticLoop::just_reaches_slip() const {
  if (!std::holds_alternative<elements::Slider>(part_.law)) return false;
  constexpr double little = 1e-6;  // of the travel
  bool reaches = false;
  for (std::size_t i = 0; i < branches_.size(); ++i) {
    const double travel = branches_[(i + 1) % branches_.size()].deflection - branches_[i].deflection;
    const std::optional<double> kink = branches_[i].course->kink();
    const double beyond = kink ? std::abs(travel) - std::abs(*kink) : -std::abs(travel);
    if (beyond > little * std::abs(travel)) return false;
    reaches = reaches || beyond >= -little * std::abs(travel);
  }
  return reaches;
}

const HystereticLoop::Branch& HystereticLoop::branch_at(double phase) const {
  assert(!branches_.empty() && "a deflection that rests has no branch");
  if (phase < branches_.front().from) phase += two_pi;
  std::size_t i = branches_.size() - 1;
  while (i > 0 && branches_[i].from > phase) --i;
  return branches_[i];
}

ForceOnTravel HystereticLoop::at(const Branch& branch, double deflection) const {
  // Friction without a spring turns a little before the given harmonics do.
  if (branch.jump != 0) return {branch.force + branch.jump - part_.at_state, 0, 0};
  ForceOnTravel found = branch.course->at(deflection - branch.deflection);
  found.force -= part_.at_state;
  return found;
}

}  // namespace trivet::nonlinear
