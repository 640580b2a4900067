// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/branch/phase_resonance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/balance/force_domain.h"
#include "trivet/nonlinear/balance/phase_equations.h"
#include "trivet/nonlinear/branch/enough_harmonics.h"
#include "trivet/nonlinear/branch/observed_path.h"
#include "trivet/numerics/periodic/branch.h"

namespace trivet::nonlinear {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using numerics::BranchPoint;

SteadyBranch followed(const ReferenceMachine& machine, const SteadyOptions& options, const PhaseEquations& at,
                      double most_left_out, const foundation::Progress& progress) {
  const PointObserver observer(machine, options);
  const ForceDomain known(machine.deflections);
  SteadyBranch found;
  observer.describe(found);
  found.harmonics = at.balance().harmonics();
  found.at_phase = options.at_phase;
  found.at_phase->behind = machine.excitation.reference.name;
  const double first = machine.excitation.first_harmonic;
  const std::optional<double> linear =
      at.linear_resonance(options.from, first * options.at_phase->from, first * options.at_phase->to);
  if (!linear)
    throw foundation::NotComputable(
        fmt::format("steady: about rest, {} nowhere lags \"{}\" by {:.4g} degrees between {:.6g} and {:.6g} Hz; give "
                    "another band or "
                    "lag",
                    options.at_phase->of, found.at_phase->behind, 360 / foundation::two_pi * options.at_phase->lag,
                    options.at_phase->from / foundation::two_pi, options.at_phase->to / foundation::two_pi));
  const std::optional<BranchPoint> start = at.near_linear(*linear, options.from);
  if (!start)
    throw foundation::NotComputable(
        fmt::format("steady: at {:.6g} times the load no motion was found at the phase near that of small motions, "
                    "{:.6g} Hz; begin "
                    "at a smaller load",
                    options.from, *linear / first / foundation::two_pi));
  if (const std::string reason =
          known.reason_unknown(at.balance(), at.motion(*start), PhaseEquations::driving(*start).omega);
      !reason.empty())
    throw foundation::NotComputable(fmt::format("steady: at {:.6g} times the load {}", options.from, reason));
  const auto observed = [&](const BranchPoint& point) {
    return observer.at(at.balance(), at.motion(point), PhaseEquations::driving(point));
  };
  const auto add = [&](const BranchPoint& point) {
    const Driving driving = PhaseEquations::driving(point);
    found.points.push_back(observed(point));
    found.left_out = std::max(found.left_out, at.balance().left_out(at.motion(point), driving.omega));
    found.held_share = std::max(found.held_share, at.balance().held_share(at.motion(point), driving.omega));
    return found.left_out <= most_left_out;
  };
  if (!add(*start)) return found;
  numerics::BranchWalk walk(at.branch(), *start, {.sharp_turns = 1e-4}, 0.02, options.from, options.to);
  std::size_t points_before = found.points.size(), folds_before = 0;  // at the last smooth point
  while (to_index(found.points.size()) < options.most_points) {
    std::optional<numerics::BranchWalk::Step> step = walk.next();
    const BranchPoint& now = walk.now();
    if (!step) {
      found.ended =
          fmt::format("no further motion beyond {:.6g} times the load: the step became too short", now.parameter);
      return found;
    }
    if (step->hops) {
      found.points.resize(points_before);
      found.folds.resize(folds_before);
      found.corners.push_back(now.parameter);
    }
    const BranchPoint& next = step->to;
    if (found.ended = known.reason_unknown(at.balance(), at.motion(next), PhaseEquations::driving(next).omega);
        !found.ended.empty())
      return found;
    const bool turns = next.parameter_direction() * now.parameter_direction() < 0;
    if (!turns && (next.parameter > options.to || next.parameter < options.from)) {
      const double end = next.parameter > options.to ? options.to : options.from;
      if (const auto last = at.branch().at(end, now, 0, step->length)) (void)add(*last);
      else found.ended = fmt::format("no motion was found at {:.6g} times the load", end);
      return found;
    }
    if (turns)
      found.folds.push_back({observed(at.branch().fold(now, step->length)), found.points.size() - 1,
                             now.parameter_direction() > 0, std::nullopt});
    if (!add(next)) return found;
    if (progress) progress("phase resonance", std::clamp(next.parameter / options.to, 0.0, 1.0));
    walk.go(std::move(*step));
    if (!walk.is_smooth()) continue;
    points_before = found.points.size();
    folds_before = found.folds.size();
  }
  found.ended = fmt::format("stopped after {} points", options.most_points);
  return found;
}

}  // namespace

SteadyBranch phase_resonances(const model::System& system, const SteadyOptions& options, const References& references,
                              const foundation::Progress& progress) {
  const ReferenceMachine machine(system, references, options.excitations, options.at_phase->of);
  check_harmonics(options, machine.excitation);
  const HeldPhase held{to_index(machine.deflections.size()) - 1, machine.excitation.harmonics.front(),
                       options.at_phase->lag, machine.excitation.reference};
  const std::vector<Index>& independent = machine.condensed.basis().independent;
  if (!std::ranges::binary_search(independent, held.deflection))
    throw foundation::InvalidInput("steady: phase.of: " + options.at_phase->of + " cannot move; name one that can");
  const bool is_given = options.harmonics > 0;
  Index harmonics = is_given ? options.harmonics : std::max<Index>(5, machine.excitation.highest());
  for (;; harmonics = more_harmonics(harmonics)) {
    const bool is_last = is_given || harmonics == most_steady_harmonics;
    const double most = is_last ? std::numeric_limits<double>::infinity() : allowed_left_out(system, options);
    const PhaseEquations at(machine, harmonics, held, options.to);
    SteadyBranch found = followed(machine, options, at, most, progress);
    if (found.left_out <= most) return found;
  }
}

}  // namespace trivet::nonlinear
