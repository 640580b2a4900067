// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/steady_branch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/harmonic_balance.h"
#include "trivet/nonlinear/periodic_stability.h"

namespace trivet::nonlinear {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using numerics::BranchPoint;

/// Lengths on the branch, in shares of the deflection and of the band.
constexpr double first_step = 0.02, longest_step = 0.2, shortest_step = 1e-9;
/// Directions of neighbouring points differ by less than about 15°.
constexpr double least_cosine = 0.966;

class Course {
 public:
  Course(const model::System& system, const SteadyOptions& options)
      : options_(options),
        assembled_(assembly::assemble(system)),
        deflections_(nonlinear_deflections(system, assembled_)),
        machine_(assembled_, deflections_, assembly::harmonic_loading(system, assembled_, options.excitations)),
        balance_(machine_, deflections_, options.harmonics),
        stability_(assembled_, deflections_),
        branch_([this](const VectorXd& unknowns, double omega,
                       numerics::Equations& equations) { balance_.evaluate(unknowns, omega, equations); },
                smallest_scale(), options.to - options.from) {}

  SteadyBranch follow(const foundation::Progress& progress) {
    SteadyBranch found;
    for (const Deflection& deflection : deflections_) found.deflections.push_back(deflection.name);
    BranchPoint now = first();
    add(now, found.points, found);
    double step = first_step;
    while (now.parameter < options_.to) {
      if (to_size_of(found) >= options_.most_points) {
        found.ended = fmt::format("stopped after {} points", options_.most_points);
        return found;
      }
      const std::optional<BranchPoint> next = branch_.after(now, step);
      if (!next || next->parameter <= 0 || turn(now, *next) < least_cosine) {
        step /= 2;
        if (step >= shortest_step) continue;
        found.ended = fmt::format("no further motion beyond {:.10g} rad/s: the step of the branch fell below {:.0e}",
                                  now.parameter, shortest_step);
        return found;
      }
      if (next->parameter_direction() * now.parameter_direction() < 0)
        if (const std::optional<BranchPoint> fold = branch_.fold(now, step)) add(*fold, found.folds, found);
      for (const double omega : options_.at)
        if ((now.parameter < omega) != (next->parameter < omega)) add_at(omega, now, *next, found);
      now = *next;
      add(now, found.points, found);
      if (now.parameter < options_.from) {
        found.ended = fmt::format("left the band downwards at {:.10g} rad/s", now.parameter);
        return found;
      }
      if (now.iterations <= 4) step = std::min(longest_step, 1.4 * step);
      if (progress) progress("steady motion", std::clamp((now.parameter - options_.from) / width(), 0.0, 1.0));
    }
    return found;
  }

 private:
  [[nodiscard]] double width() const { return options_.to - options_.from; }
  static int to_size_of(const SteadyBranch& found) { return static_cast<int>(found.points.size()); }

  /// Coefficients that stay near zero are compared with a thousandth of the linear motion.
  [[nodiscard]] VectorXd smallest_scale() const {
    constexpr double share = 1e-3;
    const VectorXd motion = balance_.linear_motion(options_.from);
    const double largest = motion.size() > 0 ? motion.cwiseAbs().maxCoeff() : 0;
    if (!(largest > 0)) throw foundation::NotComputable("steady: no excitation moves a nonlinear part");
    return VectorXd::Constant(motion.size(), share * largest);
  }

  [[nodiscard]] BranchPoint first() const {
    const std::optional<BranchPoint> point = branch_.start(balance_.linear_motion(options_.from), options_.from);
    if (!point)
      throw foundation::NotComputable(fmt::format(
          "steady: no motion was found at the lower end of the band, {:.6g} rad/s; begin at a lower frequency",
          options_.from));
    return *point;
  }

  static double turn(const BranchPoint& from, const BranchPoint& to) {
    return from.tangent.dot(to.tangent.cwiseProduct(to.scale).cwiseQuotient(from.scale).normalized());
  }

  /// Newton's method at this frequency from between two neighbours.
  void add_at(double omega, const BranchPoint& before, const BranchPoint& after, SteadyBranch& found) const {
    const double share = (omega - before.parameter) / (after.parameter - before.parameter);
    const VectorXd guess = (1 - share) * before.unknowns + share * after.unknowns;
    if (const std::optional<BranchPoint> point = branch_.start(guess, omega)) add(*point, found.at, found);
  }

  void add(const BranchPoint& point, std::vector<SteadyPoint>& list, SteadyBranch& found) const {
    SteadyPoint steady;
    steady.angular_frequency = point.parameter;
    steady.deflections = point.unknowns.reshaped(balance_.coefficients(), machine_.size());
    steady.multipliers = stability_.multipliers(balance_.laws(), point.unknowns, point.parameter);
    steady.stable = (steady.multipliers.cwiseAbs().array() < 1).all();
    found.left_out = std::max(found.left_out, balance_.left_out(point.unknowns, point.parameter));
    list.push_back(std::move(steady));
  }

  const SteadyOptions& options_;
  assembly::Assembled assembled_;
  std::vector<Deflection> deflections_;
  CondensedMachine machine_;
  HarmonicBalance balance_;
  PeriodicStability stability_;
  numerics::Branch branch_;
};

}  // namespace

SteadyBranch steady_branch(const model::System& system, const SteadyOptions& options,
                           const foundation::Progress& progress) {
  if (!(options.from > 0 && options.to > options.from && std::isfinite(options.to)))
    throw foundation::InvalidInput(
        fmt::format("steady: the band [{}, {}] rad/s must rise from above 0", options.from, options.to));
  if (options.harmonics < 1) throw foundation::InvalidInput("steady: at least one harmonic");
  return Course(system, options).follow(progress);
}

}  // namespace trivet::nonlinear
