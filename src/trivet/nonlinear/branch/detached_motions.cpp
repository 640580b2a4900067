// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/branch/detached_motions.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/nonlinear/balance/phase_equations.h"
#include "trivet/numerics/periodic/branch.h"

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

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using numerics::BranchPoint;

/// Typical deviations of the deflections: under the load, and to their nearest kinks.
std::vector<double> sizes(const SteadyPath& path, const std::vector<Deflection>& deflections, double parameter) {
  const Eigen::MatrixXd linear = path.balance().motion(path.balance().linear_motion(path.driving(parameter)));
  double largest = 0;
  std::vector<double> found;
  for (Index j = 0; j < to_index(deflections.size()); ++j) {
    double size = linear.col(j).norm();
    for (const double kink : deflections[j].law.kinks()) size = std::max(size, std::abs(kink));
    found.push_back(size);
    largest = std::max(largest, size);
  }
  for (std::size_t j = 0; j < deflections.size(); ++j)
    if (deflections[j].distance)
      for (std::size_t a = j; a < j + 3; ++a) found[a] = std::max(found[a], deflections[j].distance->extent());
  constexpr double least = 1e-3;
  for (double& size : found) size = std::max(size, least * largest);
  return found;
}

/// Amplitudes between a fifth and twenty times the typical ones, in the excited harmonics.
VectorXd random_motion(const std::vector<double>& of_size, const HarmonicBalance& balance, std::mt19937_64& random) {
  std::uniform_real_distribution<double> logarithm(std::log(0.2), std::log(20.0)), phase(0, foundation::two_pi);
  std::normal_distribution<double> mean(0, 0.3);
  const Index coefficients = balance.coefficients();
  Eigen::MatrixXd motion = Eigen::MatrixXd::Zero(coefficients, to_index(of_size.size()));
  for (std::size_t j = 0; j < of_size.size(); ++j) motion(0, to_index(j)) = mean(random) * of_size[j];
  for (const Index k : balance.excited()) {
    const double common = std::exp(logarithm(random)), common_phase = phase(random);
    for (std::size_t j = 0; j < of_size.size(); ++j) {
      const double own = common * of_size[j] * std::exp(0.5 * mean(random)),
                   turned = common_phase + mean(random) * foundation::two_pi;
      motion(2 * k - 1, to_index(j)) = own * std::cos(turned);
      motion(2 * k, to_index(j)) = own * std::sin(turned);
    }
  }
  return balance.unknowns_of(motion);
}

/// The same motion of a symmetric machine half a period later with the other sign: even harmonics change their sign.
VectorXd mirrored(const VectorXd& unknowns, Index coefficients) {
  VectorXd image = unknowns;
  for (Index i = 0; i < unknowns.size(); ++i)
    if ((i % coefficients + 1) / 2 % 2 == 0) image(i) = -image(i);
  return image;
}

/// Beside a motion that has an odd number of real multipliers above 1: along the direction in which the equations
/// change least, on both sides. A pair of stable motions on both sides of it has no connection with it in a narrow
/// band.
std::vector<VectorXd> beside_unstable(const SteadyEquations& equations, const BranchPoint& motion) {
  const SteadyEquations::Place place{motion.unknowns, motion.parameter};
  std::vector<VectorXd> found;
  if (!equations.is_beyond_fold(place)) return found;
  const std::optional<VectorXd> direction = equations.weakest_direction(place);
  if (!direction) return found;
  const VectorXd way = direction->cwiseProduct(equations.scale(motion.unknowns));
  for (const double size : {0.05, 0.2, 0.5, 1.0, 2.0})
    for (const double sense : {-1.0, 1.0}) found.emplace_back(motion.unknowns + sense * size * way);
  return found;
}

}  // namespace

DetachedPaths detached_paths(const SteadyPath& connected, const std::vector<const SteadyPath*>& known,
                             const std::vector<Deflection>& deflections, const std::vector<VectorXd>& rests,
                             const ResonancesAtLoad& resonances, const SteadyOptions& options,
                             const std::function<std::unique_ptr<SteadyPath>()>& new_path,
                             const foundation::Progress& progress) {
  constexpr int places = 24, starts = 32;
  constexpr double same = 1e-3;  // of the motion
  DetachedPaths found{{places, places * starts, 0, static_cast<int>(rests.size()), resonances.curves,
                       options.over == Parameter::frequency ? load_of_search : 0},
                      {}};
  const auto is_known = [&](const BranchPoint& motion) {
    const VectorXd image = mirrored(motion.unknowns, connected.balance().coefficients());
    const auto lies_on = [&](const SteadyPath& path) {
      constexpr std::size_t followed = 2;  // points; else the motion alone
      std::vector<BranchPoint> there = path.motions().all_at(motion.parameter);
      if (path.motions().points().size() < followed && path.motions().points().front().parameter == motion.parameter)
        there = path.motions().points();
      return std::ranges::any_of(there, [&](const BranchPoint& other) {
        return path.balance().are_same(other.unknowns, motion.unknowns, same) ||
            path.balance().are_same(other.unknowns, image, same);
      });
    };
    return std::ranges::any_of(known, [&](const SteadyPath* path) { return lies_on(*path); }) ||
        std::ranges::any_of(found.paths, [&](const auto& path) { return lies_on(*path); });
  };
  const auto take = [&](const BranchPoint& motion) {
    if (is_known(motion)) return;
    std::unique_ptr<SteadyPath> path = new_path();
    path->follow_detached(motion, progress);
    found.paths.push_back(std::move(path));
  };
  for (const SteadyEquations::Place& there : resonances.motions)
    if (there.parameter > options.from && there.parameter < options.to)
      if (const std::optional<BranchPoint> motion = connected.motion_near(there.unknowns, there.parameter))
        take(*motion);
  std::mt19937_64 random(20261126);
  for (int i = 0; i < places; ++i) {
    const double parameter = options.from + (options.to - options.from) * (i + 0.5) / places;
    if (options.over == Parameter::frequency)
      for (const BranchPoint& motion : connected.motions_over_load(parameter, load_of_search)) take(motion);
    std::vector<BranchPoint> there;
    for (const SteadyPath* path : known)
      for (BranchPoint& motion : path->motions().all_at(parameter)) there.push_back(std::move(motion));
    for (const BranchPoint& motion : there)
      for (const VectorXd& guess : beside_unstable(connected.equations(), motion)) {
        ++found.search.beside_unstable;
        if (const std::optional<BranchPoint> other = connected.motion_near(guess, parameter)) take(*other);
      }
    const std::vector<double> of_size = sizes(connected, deflections, parameter);
    for (int s = 0; s < starts; ++s)
      if (const std::optional<BranchPoint> motion =
              connected.motion_near(random_motion(of_size, connected.balance(), random), parameter))
        take(*motion);
    for (const VectorXd& rest : rests) {
      Eigen::MatrixXd guess =
          connected.balance().motion(connected.balance().linear_motion(connected.driving(parameter)));
      guess.row(0).head(rest.size()) = rest.transpose();
      if (const auto motion = connected.motion_near(connected.balance().unknowns_of(guess), parameter)) take(*motion);
    }
    foundation::report_progress(progress, "detached motions", (i + 1.0) / places);
  }
  return found;
}

}  // namespace trivet::nonlinear
