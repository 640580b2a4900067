// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/branch/resonances_at_load.h"

#include <cmath>
#include <optional>

#include "trivet/nonlinear/balance/phase_equations.h"
#include "trivet/numerics/periodic/branch_walk.h"

namespace trivet::nonlinear {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using numerics::BranchPoint;

/// The translation and the rotation with the largest harmonic, of the independent ones.
std::vector<Index> moved_most(const ReferenceMachine& machine, const HarmonicBalance& balance, const VectorXd& unknowns,
                              Index harmonic) {
  const Eigen::MatrixXd motion = balance.motion(unknowns);
  std::vector<Index> found;
  for (const bool rotation : {false, true}) {
    std::optional<Index> most;
    double largest = 0;
    for (const Index j : machine.condensed.basis().independent) {
      if (machine.deflections[j].is_rotation != rotation) continue;
      const double size = motion.col(j).segment<2>(2 * harmonic - 1).norm();
      if (size > largest) {
        largest = size;
        most = j;
      }
    }
    if (most) found.push_back(*most);
  }
  return found;
}

/// Along the curve from small motions: those at the whole load.
void follow(const PhaseEquations& at, const BranchPoint& start, double first_harmonic, double load_up_to,
            std::vector<SteadyEquations::Place>& found) {
  constexpr int most_points = 400;
  constexpr double first_step = 0.02;
  numerics::BranchWalk walk(at.branch(), start, {.sharp_turns = 1e-4}, first_step, 0, load_up_to);
  for (int i = 0; i < most_points; ++i) {
    std::optional<numerics::BranchWalk::Step> step = walk.next();
    if (!step || !(step->to.parameter > 0) || step->to.parameter > load_up_to) return;
    const BranchPoint now = walk.now();
    if ((now.parameter < 1) != (step->to.parameter < 1))
      if (const std::optional<BranchPoint> there =
              step->hops ? at.branch().start(step->to.unknowns, 1) : at.branch().at(1, now, 0, step->length))
        found.push_back({at.motion(*there), PhaseEquations::driving(*there).omega / first_harmonic});
    walk.go(std::move(*step));
  }
}

}  // namespace

ResonancesAtLoad resonances_at_load(const ReferenceMachine& machine, const SteadyOptions& options, Index harmonics,
                                    double load_up_to, const foundation::Progress& progress) {
  constexpr int most_curves = 64;
  constexpr double small = 1e-2;         // of the load
  constexpr double farthest = 5;         // of a resonance about rest from the band, as a ratio
  constexpr double least_damped = 1e-6;  // of the receptance, which an undamped mode does not have at its pole
  const double first = machine.excitation.first_harmonic;
  const PeriodicExcitation::Reference& reference = machine.excitation.reference;
  const HarmonicBalance balance(machine.condensed, machine.deflections, harmonics);
  ResonancesAtLoad found;
  for (const std::complex<double>& pole : machine.condensed.poles()) {
    if (!(pole.imag() > 0) || !(-pole.real() > least_damped * std::abs(pole))) continue;
    for (const Index harmonic : machine.excitation.harmonics) {
      const double omega = pole.imag() / static_cast<double>(harmonic), parameter = omega / first;
      if (parameter < options.from / farthest || parameter > options.to * farthest) continue;
      const VectorXd linear = balance.linear_motion({omega, small});
      for (const Index deflection : moved_most(machine, balance, linear, harmonic)) {
        if (found.curves == most_curves) return found;
        const Index cosine = machine.condensed.basis().place(deflection) * balance.coefficients() + 2 * harmonic - 1;
        const double lag = std::atan2(linear(cosine + 1), linear(cosine));  // behind cos ωt
        const PhaseEquations at(machine, harmonics,
                                {deflection, harmonic, lag + reference.phase_at(pole.imag()), reference}, 1);
        const std::optional<BranchPoint> start = at.near_linear(omega, small);
        if (!start) continue;
        foundation::report_progress(progress, "resonances over the load",
                                    static_cast<double>(found.curves++) / most_curves);
        follow(at, *start, first, load_up_to, found.motions);
      }
    }
  }
  return found;
}

}  // namespace trivet::nonlinear
