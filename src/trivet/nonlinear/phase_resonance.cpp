// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/phase_resonance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/enough_harmonics.h"
#include "trivet/nonlinear/known_forces.h"
#include "trivet/nonlinear/observed_point.h"
#include "trivet/numerics/periodic/branch_walk.h"

namespace trivet::nonlinear {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using numerics::BranchPoint;

/// Unknowns: those of the balance, and the logarithm of the frequency; parameter: the load factor. With the
/// coefficients a, b of the harmonic of the result, which is the last deflection, its phase is that of a − i b. Where
/// it lags cos ωt by ψ, a sin ψ − b cos ψ is zero; ψ is the lag behind the excitation less the phase of that.
class AtPhase {
 public:
  AtPhase(const ReferenceMachine& machine, const SteadyOptions& options, Index harmonics)
      : lag_(options.at_phase->lag),
        reference_(machine.excitation.reference),
        balance_(machine.condensed, machine.deflections, harmonics),
        cosine_((machine.condensed.size() - 1) * balance_.coefficients() + 2 * balance_.excited().front() - 1),
        branch_([this](const VectorXd& u, double load, numerics::Equations& e) { evaluate(u, load, e); }, options.to,
                [this](const VectorXd& u) { return scale(u); }) {}

  [[nodiscard]] const HarmonicBalance& balance() const { return balance_; }
  [[nodiscard]] const numerics::Branch& branch() const { return branch_; }
  [[nodiscard]] static Driving driving(const BranchPoint& point) {
    return {std::exp(point.unknowns(point.unknowns.size() - 1)), point.parameter};
  }
  [[nodiscard]] VectorXd motion(const BranchPoint& point) const { return point.unknowns.head(balance_.size()); }

  /// Where the linear motion at a load has the phase, and is largest: frequency of the first harmonic; empty: nowhere.
  [[nodiscard]] std::optional<double> linear_resonance(double load, double from, double to) const {
    constexpr int places = 4000, halvings = 60;
    const auto ahead = [&](double omega) {
      return phase_equation(balance_.linear_motion({omega, load}), lag_at(omega));
    };
    double largest = 0, found = 0, before = from;
    for (int i = 1; i <= places; ++i) {
      const double omega = from * std::pow(to / from, static_cast<double>(i) / places);
      if ((ahead(before) < 0) != (ahead(omega) < 0)) {
        double low = before, high = omega;
        for (int h = 0; h < halvings; ++h)
          ((ahead(low) < 0) == (ahead((low + high) / 2) < 0) ? low : high) = (low + high) / 2;
        const VectorXd motion = balance_.linear_motion({low, load});
        const double size = std::hypot(motion(cosine_), motion(cosine_ + 1));
        // Not at the opposite phase.
        if (slope_of_phase_equation(motion, lag_at(low)) > 0 && size > largest) {
          largest = size;
          found = low;
        }
      }
      before = omega;
    }
    return found == 0 ? std::nullopt : std::optional(found);
  }

  [[nodiscard]] std::optional<BranchPoint> near_linear(double omega, double load) const {
    VectorXd guess(balance_.size() + 1);
    guess << balance_.linear_motion({omega, load}), std::log(omega);
    return branch_.start(guess, load);
  }

 private:
  /// Behind cos ωt.
  /// @param omega  of the first harmonic
  [[nodiscard]] double lag_at(double omega) const { return lag_ - reference_.phase_at(order() * omega); }
  [[nodiscard]] double order() const { return static_cast<double>(balance_.excited().front()); }
  [[nodiscard]] double phase_equation(const VectorXd& motion, double lag) const {
    return motion(cosine_) * std::sin(lag) - motion(cosine_ + 1) * std::cos(lag);
  }
  [[nodiscard]] double slope_of_phase_equation(const VectorXd& motion, double lag) const {
    return motion(cosine_) * std::cos(lag) + motion(cosine_ + 1) * std::sin(lag);
  }

  void evaluate(const VectorXd& unknowns, double load, numerics::Equations& equations) const {
    const Index n = balance_.size();
    const double omega = std::exp(unknowns(n));
    numerics::Equations over_frequency;
    balance_.evaluate(unknowns.head(n), {omega, load}, Parameter::frequency, over_frequency);
    equations.value.resize(n + 1);
    const double lag = lag_at(omega);
    equations.value << over_frequency.value, phase_equation(unknowns, lag);
    equations.by_unknowns.setZero(n + 1, n + 1);
    equations.by_unknowns.topLeftCorner(n, n) = over_frequency.by_unknowns;
    equations.by_unknowns.topRightCorner(n, 1) = omega * over_frequency.by_parameter;
    equations.by_unknowns(n, cosine_) = std::sin(lag);
    equations.by_unknowns(n, cosine_ + 1) = -std::cos(lag);
    equations.by_unknowns(n, n) = slope_of_phase_equation(unknowns, lag) * order() * omega * reference_.delay;
    equations.by_parameter.setZero(n + 1);
    equations.by_parameter.head(n) = -balance_.linear_motion({omega, 1});
  }

  [[nodiscard]] VectorXd scale(const VectorXd& unknowns) const {
    constexpr double of_frequency = 0.1;
    const Index n = balance_.size();
    const VectorXd sizes = balance_.sizes()
                               .largest_of_kind(balance_.largest(unknowns.head(n)))
                               .cwiseMax(std::numeric_limits<double>::min());
    VectorXd found(n + 1);
    found << sizes.transpose().replicate(balance_.coefficients(), 1).reshaped(), of_frequency;
    return found;
  }

  double lag_;  ///< behind the excitation
  PeriodicExcitation::Reference reference_;
  HarmonicBalance balance_;
  Index cosine_;
  numerics::Branch branch_;
};

SteadyBranch followed(const ReferenceMachine& machine, const SteadyOptions& options, const AtPhase& at,
                      double most_left_out, const foundation::Progress& progress) {
  const PointObserver observer(machine, options);
  const KnownForces known(machine.deflections);
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
  if (const std::string reason = known.reason_unknown(at.balance(), at.motion(*start), AtPhase::driving(*start).omega);
      !reason.empty())
    throw foundation::NotComputable(fmt::format("steady: at {:.6g} times the load {}", options.from, reason));
  const auto observed = [&](const BranchPoint& point) {
    return observer.at(at.balance(), at.motion(point), AtPhase::driving(point));
  };
  const auto add = [&](const BranchPoint& point) {
    const Driving driving = AtPhase::driving(point);
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
    if (found.ended = known.reason_unknown(at.balance(), at.motion(next), AtPhase::driving(next).omega);
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
  const bool is_given = options.harmonics > 0;
  Index harmonics = is_given ? options.harmonics : std::max<Index>(5, machine.excitation.highest());
  for (;; harmonics = more_harmonics(harmonics)) {
    const bool is_last = is_given || harmonics == most_steady_harmonics;
    const double most = is_last ? std::numeric_limits<double>::infinity() : allowed_left_out(system, options);
    SteadyBranch found = followed(machine, options, AtPhase(machine, options, harmonics), most, progress);
    if (found.left_out <= most) return found;
  }
}

}  // namespace trivet::nonlinear
