// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/branch/observed_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace trivet::nonlinear {

using Eigen::Index;
using numerics::BranchPoint;

ObservedPath::ObservedPath(const ReferenceMachine& machine, SteadyPath& path, const SteadyOptions& options)
    : machine_(machine), path_(path), options_(options), observer_(machine, options) {}

SteadyBranch ObservedPath::branch(const foundation::Progress& progress) {
  const FollowedMotions& motions = path_.motions();
  SteadyBranch found;
  observer_.describe(found);
  found.harmonics = path_.balance().harmonics();
  found.left_out = path_.left_out();
  found.held_share = path_.held_share();
  found.ended = path_.ended();
  found.begun_at = path_.begun_at();
  found.closed = path_.closed();
  found.corners = motions.corners();
  for (const BranchPoint& point : motions.points()) {
    found.points.push_back(steady(point));
    note_sticking(point, found);
    if (progress)
      progress("stability", static_cast<double>(found.points.size()) / static_cast<double>(motions.points().size()));
  }
  add_points_between(found);
  if (observer_.has_winding() && (options_.deep || machine_.assembled.frequency_dependent()))
    judge_by_winding(found, progress);
  for (const BranchPoint& point : motions.requested()) {
    found.at.push_back(steady(point));
    found.at.back().shapes = observer_.shapes(path_.balance(), point.unknowns, path_.driving(point.parameter));
    if (observer_.has_winding() && options_.deep && !by_winding_) (void)contradicts(point, found.at.back());
  }
  for (const FollowedMotions::Turn& turn : motions.turns())
    found.folds.push_back({steady(turn.point), turn.after, turn.upper, std::nullopt});
  add_changes(found);
  return found;
}

/// Two stable motions may have unstable ones between them.
void ObservedPath::add_points_between(SteadyBranch& found) {
  constexpr double shortest = 2e-3;
  constexpr int most = 100;
  const FollowedMotions& motions = path_.motions();
  int added = 0;
  for (std::size_t i = 0; i + 1 < found.points.size() && added < most; ++i) {
    const bool turns =
        std::ranges::any_of(motions.turns(), [i](const FollowedMotions::Turn& turn) { return turn.after == i; });
    while (!turns && added < most && motions.step_length(i) > shortest && may_be_unstable_between(found, i) &&
           path_.split_step(i)) {
      found.points.insert(found.points.begin() + static_cast<std::ptrdiff_t>(i) + 1, steady(motions.points()[i + 1]));
      ++added;
    }
  }
}

namespace {

/// Positive for stable motions, and smooth along a path where they pass zero: at a branch point Π (1 − μ) over all
/// multipliers, at a doubling Π (1 + μ), where quasi-periodic motion begins 1 − |μ|² of the largest.
std::array<double, 3> distances_to_changes(const Eigen::VectorXcd& multipliers) {
  std::complex<double> at_plus_one = 1, at_minus_one = 1;
  for (const std::complex<double>& multiplier : multipliers) {
    at_plus_one *= 1.0 - multiplier;
    at_minus_one *= 1.0 + multiplier;
  }
  return {at_plus_one.real(), at_minus_one.real(), 1 - multipliers.cwiseAbs2().maxCoeff()};
}

}  // namespace

/// May one of them pass zero twice in a step, by the parabolas through its ends and a neighbour?
bool ObservedPath::may_be_unstable_between(const SteadyBranch& found, std::size_t step) const {
  if (!found.points[step].stable || !found.points[step + 1].stable) return false;
  constexpr double deep = 0.25;  // of the smaller end: the parabola is a guess
  const auto at = [&](std::size_t point) { return distances_to_changes(found.points[point].multipliers); };
  const FollowedMotions& motions = path_.motions();
  const double length = motions.step_length(step);
  const std::array<double, 3> all_from = at(step), all_to = at(step + 1);
  for (std::size_t kind = 0; kind < all_from.size(); ++kind) {
    const double from = all_from[kind], to = all_to[kind];
    const auto least_with = [&](double place, double value) {  // the third point, in shares of the step from its start
      const double bend = ((value - from) / place - (to - from)) / (place - 1), slope = to - from - bend;
      const double lowest = bend > 0 ? -slope / (2 * bend) : -1;
      return lowest > 0 && lowest < 1 ? from + lowest * (slope + lowest * bend) : std::min(from, to);
    };
    double least = std::min(from, to);
    if (step > 0) least = std::min(least, least_with(-motions.step_length(step - 1) / length, at(step - 1)[kind]));
    if (step + 2 < found.points.size())
      least = std::min(least, least_with(1 + motions.step_length(step + 1) / length, at(step + 2)[kind]));
    if (least < deep * std::min(from, to)) return true;
  }
  return false;
}

SteadyPoint ObservedPath::steady(const BranchPoint& point) const {
  SteadyPoint result = observer_.at(path_.balance(), point.unknowns, path_.driving(point.parameter));
  if (by_winding_) {
    result.unstable_by_winding = observer_.winding().unstable_exponents(path_.balance().motion(point.unknowns),
                                                                        path_.driving(point.parameter).omega);
    if (result.unstable_by_winding) {
      result.stable = *result.unstable_by_winding == 0;
      result.uncertain = false;
    }
  }
  return result;
}

/// The second verdict: at all points, or, of elements that depend on frequency, at some and beside each change of
/// the first one. If it contradicts the multipliers of the nearest constant matrices, it decides.
void ObservedPath::judge_by_winding(SteadyBranch& found, const foundation::Progress& progress) {
  constexpr std::size_t samples = 16;
  const std::size_t count = found.points.size(), every = 1 + count / samples;
  const auto is_beside_change = [&](std::size_t i) {
    return (i > 0 && found.points[i - 1].stable != found.points[i].stable) ||
        (i + 1 < count && found.points[i + 1].stable != found.points[i].stable);
  };
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < count; ++i)
    if (options_.deep || i % every == 0 || is_beside_change(i)) chosen.push_back(i);
  judge(chosen, found, progress);
  if (found.multipliers_of != SteadyBranch::Multipliers::constant_machine || found.winding.differs_at.empty()) return;
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < count; ++i)
    if (!std::ranges::binary_search(chosen, i)) others.push_back(i);
  judge(others, found, progress);
  found.winding.decides = by_winding_ = true;
  for (SteadyPoint& point : found.points)
    if (point.unstable_by_winding) {
      point.stable = *point.unstable_by_winding == 0;
      point.uncertain = false;
    }
}

/// Judges a motion by the winding number. Does it contradict multipliers that hold? Then stability is uncertain, unless
/// both have the same verdict.
bool ObservedPath::contradicts(const BranchPoint& point, SteadyPoint& judged) const {
  judged.unstable_by_winding = observer_.winding().unstable_exponents(path_.balance().motion(point.unknowns),
                                                                      path_.driving(point.parameter).omega);
  if (!judged.unstable_by_winding || !judged.multipliers_hold ||
      *judged.unstable_by_winding == judged.unstable_multipliers())
    return false;
  if ((*judged.unstable_by_winding == 0) != judged.stable) {
    judged.uncertain = true;
    judged.stable = false;
  }
  return true;
}

void ObservedPath::judge(const std::vector<std::size_t>& chosen, SteadyBranch& found,
                         const foundation::Progress& progress) const {
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const BranchPoint& point = path_.motions().points()[chosen[i]];
    SteadyPoint& judged = found.points[chosen[i]];
    if (contradicts(point, judged)) found.winding.differs_at.push_back(point.parameter);
    ++found.winding.points;
    if (!judged.unstable_by_winding) ++found.winding.undecided;
    foundation::report_progress(progress, "stability by winding number",
                                static_cast<double>(i) / static_cast<double>(chosen.size()));
  }
}

/// Stable motions that are known at the parameter of a fold, besides those that meet there.
std::vector<SteadyPoint> ObservedPath::landings(const MotionsAt& known, const BranchPoint& fold) const {
  constexpr double same = 1e-2;  // of the motion
  std::vector<SteadyPoint> stable;
  for (const BranchPoint& other : known(fold.parameter)) {
    if (path_.balance().are_same(other.unknowns, fold.unknowns, same)) continue;
    SteadyPoint point = steady(other);
    if (point.stable) stable.push_back(std::move(point));
  }
  return stable;
}

void ObservedPath::add_landings(const MotionsAt& known, SteadyBranch& branch) const {
  for (std::size_t i = 0; i < branch.folds.size(); ++i) {
    std::vector<SteadyPoint> there = landings(known, path_.motions().turns()[i].point);
    branch.folds[i].stable_there = there.size();
    if (there.size() == 1) branch.folds[i].lands = std::move(there.front());
  }
}

void ObservedPath::note_sticking(const BranchPoint& point, SteadyBranch& found) const {
  const LawSet& laws = path_.balance().laws();
  const Eigen::MatrixXd motion = path_.balance().motion(point.unknowns);
  for (Index j = 0; j < motion.cols(); ++j) {
    const LawHarmonics& law = laws.single()[j];
    const std::string& name = machine_.deflections[j].name;
    if (law.law().hysteretic().empty() || std::ranges::find(found.sticking, name) != found.sticking.end()) continue;
    const LawOverPeriod course = laws.course(j, motion, path_.driving(point.parameter).omega);
    if (std::ranges::any_of(course.loops(),
                            [](const HystereticLoop& loop) { return loop.sticks() || loop.just_reaches_slip(); }))
      found.sticking.push_back(name);
  }
  for (const LawSet::Rubbing& one : laws.rubbings()) {
    std::string name = machine_.deflections[one.on[1]].name;
    if (one.law.is_ring()) name = name.substr(0, name.find('.'));
    if (std::ranges::find(found.sticking, name) != found.sticking.end()) continue;
    if (laws.loop(one, motion, path_.driving(point.parameter).omega).always_sticks()) found.sticking.push_back(name);
  }
}

void ObservedPath::add_changes(SteadyBranch& found) const {
  for (std::size_t i = 0; i + 1 < found.points.size(); ++i) {
    if (found.points[i].stable == found.points[i + 1].stable) continue;
    if (found.points[i].uncertain || found.points[i + 1].uncertain) continue;
    const auto is_fold_near = [&](std::size_t steps) {
      return std::ranges::any_of(
          found.folds, [&](const Fold& fold) { return std::max(fold.after, i) - std::min(fold.after, i) <= steps; });
    };
    if (is_fold_near(0)) continue;
    const bool multipliers_hold = found.points[i].multipliers_hold && found.points[i + 1].multipliers_hold;
    StabilityChange change = change_after(i, by_winding_ || !multipliers_hold);
    // Multipliers pass 1 beside the fold of the harmonics by what the harmonics leave out.
    if (change.kind == StabilityChange::Kind::branch_point && is_fold_near(1)) continue;
    found.changes.push_back(std::move(change));
  }
}

/// Where the largest multiplier passes the unit circle between a point and the next one.
/// @param by_number  located by the number of unstable exponents instead
StabilityChange ObservedPath::change_after(std::size_t point, bool by_number) const {
  constexpr double of_multipliers = 1e-11;
  // Where another curve crosses, Newton's method along this one has no unique step: as near as it converges.
  constexpr std::array<double, 4> accurate = {1e-10, 1e-8, 1e-6, 1e-4};
  const auto beyond_circle = [&](const BranchPoint& there) {
    return observer_.stability()
               .multipliers(path_.balance().laws(), path_.balance().motion(there.unknowns).reshaped(),
                            path_.driving(there.parameter).omega, of_multipliers)
               .values.cwiseAbs()
               .maxCoeff() -
        1;
  };
  const auto by_winding = [&](const BranchPoint& there) {
    const std::optional<int> unstable = observer_.winding().unstable_exponents(path_.balance().motion(there.unknowns),
                                                                               path_.driving(there.parameter).omega);
    return unstable && *unstable > 0 ? 1.0 : -1.0;
  };
  const FollowedMotions& motions = path_.motions();
  // Without damping multipliers stay on the circle until two of them meet, and leave it like a square root: its place
  // is found from where they are clearly outside, not from round-off.
  const double here = beyond_circle(motions.points()[point]), next = beyond_circle(motions.points()[point + 1]);
  constexpr double on_circle = 1e-6, outside = 1e-4;
  const double level = std::min(here, next) > -on_circle ? std::min(outside, std::max(here, next) / 2) : 0;
  const auto excess = [&](const BranchPoint& there) { return beyond_circle(there) - level; };
  std::optional<BranchPoint> middle;
  for (const double near : accurate)
    if (!middle)
      middle = by_number ? motions.zero_after(point, by_winding, near) : motions.zero_after(point, excess, near);
  if (!middle) {  // not located: the unstable one of both points is the nearest that shows the kind
    const bool ends_unstable = next > here;
    middle = motions.points()[ends_unstable ? point + 1 : point];
  }
  StabilityChange change{steady(*middle), point};
  Index critical = 0;
  change.point.multipliers.cwiseAbs().maxCoeff(&critical);
  const std::complex<double> multiplier = change.point.multipliers(critical);
  constexpr double real_axis = 1e-6;
  change.kind = std::abs(multiplier.imag()) > real_axis ? StabilityChange::Kind::quasi_periodic
      : multiplier.real() < 0                           ? StabilityChange::Kind::period_doubling
                                                        : StabilityChange::Kind::branch_point;
  return change;
}

}  // namespace trivet::nonlinear
