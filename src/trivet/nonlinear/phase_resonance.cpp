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

namespace trivet::nonlinear {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using numerics::BranchPoint;

/// Unknowns: those of the balance, and the logarithm of the frequency; parameter: the load factor. With the
/// coefficients a, b of the harmonic of the result, which is the last deflection, its phase is that of a − i b, and a
/// sin(lag) − b cos(lag) is zero.
class AtPhase {
 public:
  AtPhase(const ReferenceMachine& machine, const SteadyOptions& options, Index harmonics)
      : lag_(options.at_phase->lag),
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

  /// The motion at a small load: where the linear one has the phase, and is largest.
  [[nodiscard]] std::optional<BranchPoint> start(double load, double from, double to) const {
    constexpr int places = 4000, halvings = 60;
    const auto ahead = [&](double omega) { return phase_equation(balance_.linear_motion({omega, load})); };
    double largest = 0, found = 0, before = from;
    for (int i = 1; i <= places; ++i) {
      const double omega = from * std::pow(to / from, static_cast<double>(i) / places);
      if ((ahead(before) < 0) != (ahead(omega) < 0)) {
        double low = before, high = omega;
        for (int h = 0; h < halvings; ++h)
          ((ahead(low) < 0) == (ahead((low + high) / 2) < 0) ? low : high) = (low + high) / 2;
        const VectorXd motion = balance_.linear_motion({low, load});
        const double size = std::hypot(motion(cosine_), motion(cosine_ + 1));
        // At −lag, not at the opposite phase.
        if (motion(cosine_) * std::cos(lag_) + motion(cosine_ + 1) * std::sin(lag_) > 0 && size > largest) {
          largest = size;
          found = low;
        }
      }
      before = omega;
    }
    if (found == 0) return std::nullopt;
    VectorXd guess(balance_.size() + 1);
    guess << balance_.linear_motion({found, load}), std::log(found);
    return branch_.start(guess, load);
  }

 private:
  [[nodiscard]] double phase_equation(const VectorXd& motion) const {
    return motion(cosine_) * std::sin(lag_) - motion(cosine_ + 1) * std::cos(lag_);
  }

  void evaluate(const VectorXd& unknowns, double load, numerics::Equations& equations) const {
    const Index n = balance_.size();
    const double omega = std::exp(unknowns(n));
    numerics::Equations over_frequency;
    balance_.evaluate(unknowns.head(n), {omega, load}, Parameter::frequency, over_frequency);
    equations.value.resize(n + 1);
    equations.value << over_frequency.value, phase_equation(unknowns);
    equations.by_unknowns.setZero(n + 1, n + 1);
    equations.by_unknowns.topLeftCorner(n, n) = over_frequency.by_unknowns;
    equations.by_unknowns.topRightCorner(n, 1) = omega * over_frequency.by_parameter;
    equations.by_unknowns(n, cosine_) = std::sin(lag_);
    equations.by_unknowns(n, cosine_ + 1) = -std::cos(lag_);
    equations.by_parameter.setZero(n + 1);
    equations.by_parameter.head(n) = -balance_.linear_motion({omega, 1});
  }

  [[nodiscard]] VectorXd scale(const VectorXd& unknowns) const {
    constexpr double of_frequency = 0.1;
    const Index n = balance_.size();
    VectorXd found =
        VectorXd::Constant(n + 1, std::max(unknowns.head(n).cwiseAbs().maxCoeff(), std::numeric_limits<double>::min()));
    found(n) = of_frequency;
    return found;
  }

  double lag_;
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
  const double first = machine.excitation.first_harmonic;
  std::optional<BranchPoint> now = at.start(options.from, first * options.at_phase->from, first * options.at_phase->to);
  if (!now)
    throw foundation::NotComputable(
        fmt::format("steady: {} nowhere lags by {:.4g} degrees at {:.4g} times the load between {:.6g} and {:.6g} Hz; "
                    "give another band or lag, or begin at a smaller load",
                    options.at_phase->of, 360 / foundation::two_pi * options.at_phase->lag, options.from,
                    options.at_phase->from / foundation::two_pi, options.at_phase->to / foundation::two_pi));
  if (const std::string reason = known.reason_unknown(at.balance(), at.motion(*now), AtPhase::driving(*now).omega);
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
  if (!add(*now)) return found;
  double step = 0.02;
  while (to_index(found.points.size()) < options.most_points) {
    std::optional<numerics::Branch::Advance> advance = at.branch().advance(*now, step, {.sharp_turns = 1e-4});
    if (!advance) {
      found.ended =
          fmt::format("no further motion beyond {:.6g} times the load: the step became too short", now->parameter);
      return found;
    }
    BranchPoint next = std::move(advance->to);
    if (found.ended = known.reason_unknown(at.balance(), at.motion(next), AtPhase::driving(next).omega);
        !found.ended.empty())
      return found;
    const bool turns = next.parameter_direction() * now->parameter_direction() < 0;
    if (!turns && (next.parameter > options.to || next.parameter < options.from)) {
      const double end = next.parameter > options.to ? options.to : options.from;
      if (const auto last = at.branch().at(end, *now, 0, advance->length)) (void)add(*last);
      else found.ended = fmt::format("no motion was found at {:.6g} times the load", end);
      return found;
    }
    if (turns)
      found.folds.push_back({observed(at.branch().fold(*now, advance->length)), found.points.size() - 1,
                             now->parameter_direction() > 0, std::nullopt});
    if (!add(next)) return found;
    now = std::move(next);
    if (progress) progress("phase resonance", std::clamp(now->parameter / options.to, 0.0, 1.0));
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
