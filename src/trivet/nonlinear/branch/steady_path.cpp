// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/branch/steady_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/laws/end_reason.h"
#include "trivet/numerics/periodic/branch.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::VectorXd;
using numerics::BranchPoint;

namespace {

/// Frequencies at which a linear mode resonates, and beside them; a second and a third of them for the harmonics. A
/// mode that hardly moves the nonlinear parts does not bend the branch, which would pass it in one step.
std::vector<double> resonances(const Eigen::VectorXcd& poles, const PeriodicExcitation& excitation,
                               const SteadyOptions& options) {
  std::vector<double> found;
  if (options.over != Parameter::frequency) return found;
  constexpr double most_damped = 0.3;
  for (const std::complex<double>& pole : poles) {
    if (!(pole.imag() > 0) || std::abs(pole.real()) > most_damped * std::abs(pole)) continue;
    for (const Index harmonic : excitation.harmonics) {
      const double order = static_cast<double>(harmonic) * excitation.first_harmonic;
      // At the pole of an undamped mode the receptance has no value.
      constexpr double least_damped = 1e-6, near = 1e-3;
      if (std::abs(pole.real()) < least_damped * std::abs(pole)) {
        for (const double beside : {1 - near, 1 + near}) found.push_back(beside * pole.imag() / order);
        continue;
      }
      for (const double beside : {0.0, -1.0, 1.0}) found.push_back((pole.imag() + beside * pole.real()) / order);
      for (const double multiple : {2.0, 3.0}) found.push_back(pole.imag() / (multiple * order));
    }
  }
  std::erase_if(found, [&](double omega) { return !(omega > options.from && omega < options.to); });
  std::ranges::sort(found);
  found.erase(std::ranges::unique(found).begin(), found.end());
  return found;
}

}  // namespace

SteadyPath::SteadyPath(const CondensedMachine& machine, const std::vector<Deflection>& deflections,
                       const PeriodicExcitation& excitation, const SteadyOptions& options, Index harmonics)
    : options_(options),
      resonances_(resonances(machine.poles(), excitation, options)),
      equations_(machine, deflections, excitation, options, harmonics),
      known_(deflections),
      branch_(equations_.branch()),
      motions_(branch_, options.at),
      most_points_(options.most_points) {}

SteadyPath::Known SteadyPath::known() const { return *first_; }

/// With more harmonics, which are zero at first.
std::optional<BranchPoint> SteadyPath::near(const Known& known) const {
  assert(known.motion.rows() <= balance().coefficients() && "harmonics are only added");
  Eigen::MatrixXd motion = Eigen::MatrixXd::Zero(balance().coefficients(), known.motion.cols());
  motion.topRows(known.motion.rows()) = known.motion;
  return motion_near(balance().unknowns_of(motion), known.parameter);
}

/// Where fewer harmonics had none there, only near the linear one: the longer ways take long.
std::optional<BranchPoint> SteadyPath::motion_at_lower_end(const Known* known) const {
  if (!known) return first_motion(equations_, branch_, options_.from);
  std::optional<BranchPoint> found = branch_.start(balance().linear_motion(driving(options_.from)), options_.from);
  if (found || known->parameter > options_.from) return found;
  if ((found = near(*known))) return found;
  return first_motion(equations_, branch_, options_.from);
}

std::string SteadyPath::task() const {
  return fmt::format("steady motion, {} {}", balance().harmonics(),
                     balance().harmonics() == 1 ? "harmonic" : "harmonics");
}

bool SteadyPath::follow(double most_left_out, const Known* known, const foundation::Progress& progress) {
  foundation::report_progress(progress, task(), 0);
  const std::optional<BranchPoint> start = motion_at_lower_end(known);
  const std::string reason = start
      ? unknown_forces(*start)
      : fmt::format("no motion was found at the lower end of the band, {}", equations_.place(options_.from));
  if (reason.empty()) return begin(*start, most_left_out) && walk(most_left_out, {}, progress);
  std::optional<BranchPoint> above;
  if (known && known->parameter > options_.from) above = near(*known);
  if (!above) above = lowest_motion(nullptr);
  if (!above)
    throw foundation::NotComputable(
        fmt::format("steady: {}; at {} places above it no motion with known forces was found either; choose another "
                    "band{}",
                    reason, places_above, start ? "" : known_.hint()));
  if (!follow_through(*above, most_left_out, progress)) return false;
  if (std::min(points().front().parameter, points().back().parameter) > options_.from) {
    begun_at_ = above->parameter;
    if (ended_.empty()) ended_ = reason + "; the curve of motions found above it does not come there";
  }
  return true;
}

bool SteadyPath::follow_above(const SteadyPath& returned, double most_left_out, const foundation::Progress& progress) {
  const std::optional<BranchPoint> above = lowest_motion(&returned);
  if (!above) return true;
  if (!follow_through(*above, most_left_out, progress)) return false;
  if (std::min(points().front().parameter, points().back().parameter) > options_.from) {
    begun_at_ = above->parameter;
    if (ended_.empty()) ended_ = "the curve of motions does not come to the lower end of the band";
  }
  return true;
}

/// The first motion whose forces are known on the way from the lower end of the band to the upper one: by Newton's
/// method from the linear motion, and only if that finds none by the longer ways to one.
std::optional<BranchPoint> SteadyPath::lowest_motion(const SteadyPath* except) const {
  constexpr double same = 1e-3;  // of the motion
  const auto is_on_it = [&](const BranchPoint& motion) {
    if (!except) return false;
    const std::vector<BranchPoint> there = except->motions().all_at(motion.parameter);
    return std::ranges::any_of(
        there, [&](const BranchPoint& one) { return balance().are_same(one.unknowns, motion.unknowns, same); });
  };
  const double ratio = std::pow(options_.to / options_.from, 1.0 / (places_above + 1));
  for (const bool by_all_ways : {false, true}) {
    double parameter = options_.from;
    for (int i = 0; i < places_above; ++i) {
      parameter *= ratio;
      std::optional<BranchPoint> found = by_all_ways
          ? first_motion(equations_, branch_, parameter)
          : branch_.start(balance().linear_motion(driving(parameter)), parameter);
      if (found && unknown_forces(*found).empty() && !is_on_it(*found)) return found;
    }
  }
  return std::nullopt;
}

std::vector<BranchPoint> SteadyPath::motions_over_load(double parameter, double most_load) const {
  std::vector<BranchPoint> found = nonlinear::motions_over_load(equations_, branch_, parameter, most_load);
  std::erase_if(found, [&](const BranchPoint& motion) { return !unknown_forces(motion).empty(); });
  return found;
}

/// There may be many such curves, of twice the harmonics, whose motions hardly differ.
void SteadyPath::limit_points_of_further_curve() {
  constexpr Index fewest = 200, most = 1000, work = 100'000;
  most_points_ = std::min(most_points_, std::clamp(work / balance().size(), fewest, most));
}

void SteadyPath::follow_detached(const BranchPoint& start, const foundation::Progress& progress) {
  limit_points_of_further_curve();
  (void)follow_through(start, std::numeric_limits<double>::infinity(), progress);
}

bool SteadyPath::follow_through(const BranchPoint& start, double most_left_out, const foundation::Progress& progress) {
  leaves_downwards_ = true;
  if (!begin(start, most_left_out)) return false;
  if (!walk(most_left_out, {{start.unknowns, start.parameter}}, progress)) return false;
  closed_ = stopped_at_.has_value();
  if (closed_) return true;
  const FollowedMotions onward(std::move(motions_));
  const std::string onward_ended = ended_;
  motions_.clear();
  ended_.clear();
  if (!begin(FollowedMotions::reversed(start), most_left_out) || !walk(most_left_out, {}, progress)) return false;
  motions_.reverse_and_append(onward);
  motions_.remove_turns_of_round_off();
  if (ended_.empty()) ended_ = onward_ended;
  else if (!onward_ended.empty() && ended_ != onward_ended) ended_ += "; " + onward_ended;
  return true;
}

bool SteadyPath::follow_branched(const SteadyEquations::Place& start, const VectorXd& along,
                                 const std::vector<SteadyEquations::Place>& ends,
                                 const foundation::Progress& progress) {
  constexpr double any = std::numeric_limits<double>::infinity();
  limit_points_of_further_curve();
  leaves_downwards_ = true;
  const Index n = start.unknowns.size();
  assert(along.size() == 0 || along.size() == n + 1);
  const std::optional<VectorXd> weakest = equations_.weakest_direction(start);
  if (!weakest) return false;
  BranchPoint first{start.unknowns, start.parameter, VectorXd(n + 1), VectorXd::Zero(n + 1), 0};
  first.scale << equations_.scale(start.unknowns), equations_.width();
  first.tangent.head(n) = *weakest;
  if (along.size() > 0) first.tangent -= along.normalized().dot(first.tangent) * along.normalized();
  constexpr double least = 0.5;  // else the weakest direction is that of the other curve: at a fold
  if (first.tangent.norm() < least) return false;
  first.tangent.normalize();
  (void)begin(first, any);
  (void)walk(any, ends, progress);
  constexpr std::size_t fewest = 4;
  return points().size() >= fewest;
}

namespace {

/// The nearest of some places to a parameter that a straight step has at about a share of it.
std::optional<std::size_t> nearest(const std::vector<SteadyEquations::Place>& places, const BranchPoint& now,
                                   const BranchPoint& next, double share) {
  const double change = next.parameter - now.parameter, parameter = now.parameter + share * change,
               near = 5e-3 * parameter + std::abs(change);
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (now.tangent.dot(now.way_to(places[i].unknowns, places[i].parameter)) <= 0) continue;  // behind
    const double away = std::abs(places[i].parameter - parameter);
    if (away < near && !(found && std::abs(places[*found].parameter - parameter) <= away)) found = i;
  }
  return found;
}

}  // namespace

/// Does the step to the next point pass one of these places?
std::optional<std::size_t> SteadyPath::passed(const std::vector<SteadyEquations::Place>& ends, const BranchPoint& next,
                                              double length) const {
  constexpr std::size_t fewest = 4;  // before it can return to its start
  const BranchPoint& now = points().back();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (points().size() < fewest && ends[i].unknowns == points().front().unknowns) continue;
    const VectorXd way = now.way_to(ends[i].unknowns, ends[i].parameter);
    constexpr double beside = 0.2;  // of the step
    if (now.tangent.dot(way) >= 0 && way.norm() <= length && next.tangent.dot(now.tangent) > 0 &&
        (way - now.tangent.dot(way) * now.tangent).norm() <= beside * length)
      return i;
  }
  return std::nullopt;
}

/// A motion of twice the period becomes one of the excitation's, and beyond is what it was half of that period later.
/// @returns the share of the step to the next point at which it does, if it does
std::optional<double> SteadyPath::returns_to_one_period(const BranchPoint& next) const {
  const std::vector<Index>& excited = balance().excited();
  if (std::ranges::any_of(excited, [](Index k) { return k % 2 != 0; })) return std::nullopt;
  const Index C = balance().coefficients(), deflections = next.unknowns.size() / C;
  const VectorXd& now = points().back().unknowns;
  assert(now.size() == next.unknowns.size() && next.unknowns.size() % C == 0);
  double product = 0, size = 0, next_size = 0;
  for (Index k = 1; 2 * k < C; k += 2)
    for (Index j = 0; j < deflections; ++j) {
      const auto here = now.segment<2>(j * C + 2 * k - 1), there = next.unknowns.segment<2>(j * C + 2 * k - 1);
      product += here.dot(there);
      size += here.squaredNorm();
      next_size += there.squaredNorm();
    }
  constexpr double opposite = -0.5;  // the cosine; else it only changes its shape
  if (!(product < opposite * std::sqrt(size * next_size))) return std::nullopt;
  return std::sqrt(size) / (std::sqrt(size) + std::sqrt(next_size));
}

/// Goes on from the last point to an end of the band, or to one of the places.
bool SteadyPath::walk(double most_left_out, const std::vector<SteadyEquations::Place>& ends,
                      const foundation::Progress& progress) {
  constexpr double first_step = 0.02;  // in shares of the deflection and of the band
  // A short step may turn by any angle: a slider begins to slip in both senses.
  constexpr numerics::StepControl control{.sharp_turns = 1e-4};
  numerics::BranchWalk walk(branch_, points().back(), control, first_step, options_.from, options_.to);
  double farthest = 0;  // of the band
  Extent smooth = extent();
  while (points().back().parameter < options_.to ||
         (points().size() == 1 && points().back().parameter_direction() < 0)) {
    if (to_index(points().size()) >= most_points_) {
      ended_ = fmt::format("stopped after {} points", most_points_);
      break;
    }
    std::optional<numerics::BranchWalk::Step> step = walk.next();
    const BranchPoint& now = walk.now();
    if (step && step->hops) {
      cut_to(smooth);
      motions_.add_corner(now.parameter);
    }
    if (!step || !(step->to.parameter > 0)) {
      ended_ = no_further(now);
      break;
    }
    const bool beyond_upper = step->to.parameter > options_.to,
               beyond_lower = step->to.parameter < options_.from && now.parameter > options_.from;
    if (beyond_upper || beyond_lower) {
      std::optional<BranchPoint> end = branch_.at(beyond_upper ? options_.to : options_.from, now, 0, step->length);
      if (!end) {
        walk.shorten(step->length / 2);
        constexpr double shortest = 2e-7;
        if (step->length > shortest) continue;
        ended_ = fmt::format("no motion was found at the {} end of the band", beyond_upper ? "upper" : "lower");
        break;
      }
      if ((end->parameter_direction() > 0) != beyond_upper) end->tangent = -end->tangent;
      step->length = numerics::Branch::length(now, *end);
      step->to = std::move(*end);
    }
    const BranchPoint& next = step->to;
    stopped_at_ = passed(ends, next, step->length);
    const std::optional<double> returns = ends.empty() ? std::nullopt : returns_to_one_period(next);
    if (returns && !stopped_at_) stopped_at_ = nearest(ends, now, next, *returns);
    if (returns && !stopped_at_) break;
    if (stopped_at_) {
      const SteadyEquations::Place& there = ends[*stopped_at_];
      const bool closes = there.unknowns == points().front().unknowns && points().front().tangent.dot(now.tangent) > 0;
      BranchPoint end = closes ? points().front() : now;
      end.unknowns = there.unknowns;
      end.parameter = there.parameter;
      (void)add_step(end, numerics::Branch::length(now, end), most_left_out);
      break;
    }
    if (grows_without_limit(next)) {
      ended_ = fmt::format(
          "the motion grows without limit at {}: nothing dissipates what the excitation feeds there; "
          "add damping",
          equations_.place(next.parameter));
      break;
    }
    if (const std::string reason = unknown_forces(next); !reason.empty()) {
      constexpr double shortest = 1e-4;
      if (step->length > shortest && !step->hops) {
        walk.shorten(step->length / 2);
        continue;
      }
      ended_ = reason;
      break;
    }
    const std::optional<std::vector<BranchPoint>> on_the_way = between(now, next);
    constexpr double least = 1e-5;
    if (!on_the_way && step->length > least && !step->hops) {
      walk.shorten(step->length / 2);
      continue;
    }
    for (const BranchPoint& there : on_the_way.value_or(std::vector<BranchPoint>()))
      if (!add_step(there, numerics::Branch::length(points().back(), there), most_left_out)) return false;
    const bool is_whole = !on_the_way || on_the_way->empty();
    if (!add_step(next, is_whole ? step->length : numerics::Branch::length(points().back(), next), most_left_out))
      return false;
    walk.go(std::move(*step));
    if (walk.is_smooth()) smooth = extent();
    const double parameter = walk.now().parameter;
    if (parameter <= options_.from) {
      returned_ = !leaves_downwards_;
      break;
    }
    farthest = std::max(farthest, std::clamp((parameter - options_.from) / equations_.width(), 0.0, 1.0));
    foundation::report_progress(progress, task(), farthest);
  }
  motions_.remove_turns_of_round_off();
  return true;
}

/// Why the path ends at a point from which no step leads further.
std::string SteadyPath::no_further(const BranchPoint& point) const {
  constexpr double ahead = 1e-3;
  const Index size = point.unknowns.size();
  const VectorXd beyond = point.unknowns + ahead * point.tangent.head(size).cwiseProduct(point.scale.head(size));
  return fmt::format("no further motion beyond {}: the step of the branch became too short{}",
                     equations_.place(point.parameter),
                     end_reason(known_.deflections(), balance().laws(), balance().motion(point.unknowns),
                                balance().motion(beyond), equations_.driving(point.parameter).omega));
}

/// On the way to an unbounded resonance: it grows and grows at one place.
bool SteadyPath::grows_without_limit(const BranchPoint& next) const {
  constexpr double beyond = 1e5, at_once = 1e-7;
  const BranchPoint& now = points().back();
  const double first = points().front().unknowns.norm(), size = next.unknowns.norm();
  return first > 0 && size > beyond * first && size > now.unknowns.norm() &&
      std::abs(next.parameter - now.parameter) < at_once * next.parameter;
}

/// Of a motion over which the forces are not known, with its place.
std::string SteadyPath::unknown_forces(const BranchPoint& point) const {
  const std::string reason =
      known_.reason_unknown(balance(), point.unknowns, equations_.driving(point.parameter).omega);
  return reason.empty() ? reason : fmt::format("at {} {}", equations_.place(point.parameter), reason);
}

bool SteadyPath::begin(const BranchPoint& first, double most_left_out) {
  motions_.begin(first);
  if (!first_) first_ = {balance().motion(first.unknowns), first.parameter};
  return note_left_out(first, most_left_out);
}

bool SteadyPath::add_step(const BranchPoint& next, double length, double most_left_out) {
  motions_.add(next, length);
  return note_left_out(next, most_left_out);
}

/// @returns whether it is at most that everywhere so far
bool SteadyPath::note_left_out(const BranchPoint& point, double most) {
  const double omega = equations_.driving(point.parameter).omega;
  left_out_ = std::max(left_out_, balance().left_out(point.unknowns, omega));
  held_share_ = std::max(held_share_, balance().held_share(point.unknowns, omega));
  return left_out_ <= most;
}

/// The motions at the resonances between two points. Empty if one is not found on the way: the step has passed
/// something.
std::optional<std::vector<BranchPoint>> SteadyPath::between(const BranchPoint& now, const BranchPoint& next) const {
  std::vector<BranchPoint> found;
  if (next.parameter_direction() * now.parameter_direction() < 0) return found;
  for (const double omega : resonances_) {
    if (!((omega - now.parameter) * (omega - next.parameter) < 0)) continue;
    std::optional<BranchPoint> there = branch_.at(omega, now, next);
    if (!there) return std::nullopt;
    if (there->parameter_direction() * now.parameter_direction() < 0) there->tangent = -there->tangent;
    found.push_back(std::move(*there));
  }
  if (next.parameter < now.parameter) std::ranges::reverse(found);
  return found;
}

void SteadyPath::cut_to(const Extent& end) {
  motions_.cut_to(end.motions);
  left_out_ = end.left_out;
  held_share_ = end.held_share;
}

}  // namespace trivet::nonlinear
