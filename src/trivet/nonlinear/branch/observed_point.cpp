// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/branch/observed_path.h"

#include <cmath>
#include <optional>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/nonlinear/laws/contact_share.h"
#include "trivet/numerics/linalg/lane_lu.h"

namespace trivet::nonlinear {
namespace {

/// The multipliers of a fixed amplitude do not see folds over it. There the determinant of the balance changes its
/// sign, which is positive on stable motions as it is for a linear machine.
bool is_behind_fold(const HarmonicBalance& balance, const Eigen::VectorXd& unknowns, const Driving& driving) {
  numerics::Equations equations;
  balance.evaluate(unknowns, driving, Parameter::frequency, equations);
  return numerics::LaneLu(equations.by_unknowns).determinant_sign() < 0;
}

}  // namespace

PointObserver::PointObserver(const ReferenceMachine& machine, const SteadyOptions& options)
    : machine_(machine),
      options_(options),
      observer_(machine.system, machine.assembled, machine.excitation, machine.deflections, options.of,
                options.quantity, options.quantities),
      stability_(machine.assembled, machine.deflections),
      winding_(machine.condensed, machine.deflections) {
  for (std::size_t j = 0; j < machine.deflections.size(); ++j) {
    const Deflection& deflection = machine.deflections[j];
    of_amplitude_ = of_amplitude_ || !deflection.law.of_amplitude().empty();
    const auto [low, high] = deflection.law.untouched();
    const bool is_ring = deflection.distance && deflection.distance->is_ring();
    if (std::isfinite(low) || std::isfinite(high) || is_ring) stops_.push_back(j);
  }
}

void PointObserver::describe(SteadyBranch& branch) const {
  branch.over = options_.over;
  branch.first_harmonic = machine_.excitation.first_harmonic;
  branch.of_shaft = machine_.excitation.of_shaft;
  branch.excitations = machine_.excitation.names;
  using Multipliers = SteadyBranch::Multipliers;
  branch.of_amplitude = of_amplitude_;
  branch.multipliers_of = machine_.assembled.frequency_dependent() ? Multipliers::constant_machine
      : stability_.is_of_viscous_machine()                         ? Multipliers::viscous_machine
                                                                   : Multipliers::machine;
  for (const Deflection& deflection : machine_.deflections) branch.deflections.push_back(deflection.name);
  for (const std::size_t stop : stops_) branch.stops.push_back(machine_.deflections[stop].name);
  for (const assembly::Channel& channel : observer_.channels()) {
    branch.results.push_back(channel.name);
    branch.units.push_back(channel.unit);
  }
}

bool PointObserver::has_winding() const {
  const assembly::Assembled& assembled = machine_.assembled;
  return !of_amplitude_ && !(assembled.frequency_dependent() ? assembled.constant : assembled.matrices).lossy();
}

SteadyPoint PointObserver::at(const HarmonicBalance& balance, const Eigen::VectorXd& unknowns,
                              const Driving& driving) const {
  SteadyPoint result;
  const auto [omega, factor] = driving;
  result.angular_frequency = omega / machine_.excitation.first_harmonic;
  result.load_factor = factor;
  result.deflections = balance.motion(unknowns);
  if (!observer_.channels().empty()) {
    const Eigen::MatrixXd forces = balance.forces(unknowns, omega);
    std::optional<ForceRemainder> remainder;
    if (observer_.follows_forces()) remainder.emplace(balance.laws(), result.deflections, forces, omega);
    result.results = observer_.at(machine_.condensed.coordinates(forces, omega, factor), forces, omega, factor,
                                  remainder ? &*remainder : nullptr);
  }
  PeriodicStability::Multipliers multipliers =
      stability_.multipliers(balance.laws(), result.deflections.reshaped(), omega);
  result.multipliers = std::move(multipliers.values);
  result.multiplier_uncertainty = multipliers.uncertainty;
  constexpr double accurate = 1e-5;
  result.multipliers_hold = multipliers.confirmed && multipliers.uncertainty <= accurate;
  for (const std::size_t stop : stops_) result.contact.push_back(contact(stop, balance, result));
  if (!result.multipliers_hold && has_winding() && !stability_.is_undamped())
    result.unstable_by_winding = winding_.unstable_exponents(result.deflections, omega);
  const int unstable = result.unstable_by_winding.value_or(result.unstable_multipliers());
  result.uncertain = !result.multipliers_hold && !result.unstable_by_winding;
  result.stable = !result.uncertain && unstable == 0 && !(of_amplitude_ && is_behind_fold(balance, unknowns, driving));
  return result;
}

std::vector<response::DeflectionShape> PointObserver::shapes(const HarmonicBalance& balance,
                                                             const Eigen::VectorXd& unknowns,
                                                             const Driving& driving) const {
  const auto [omega, factor] = driving;
  const Eigen::MatrixXcd coordinates = machine_.condensed.coordinates(balance.forces(unknowns, omega), omega, factor);
  const PeriodicExcitation& excitation = machine_.excitation;
  std::vector<response::DeflectionShape> list;
  for (Eigen::Index k = 0; k < coordinates.cols(); ++k) {
    response::SteadyMotion motion{static_cast<double>(k) * omega, coordinates.col(k),
                                  Eigen::VectorXcd::Zero(machine_.assembled.ground.size())};
    for (std::size_t e = 0; e < excitation.harmonics.size(); ++e)
      if (excitation.harmonics[e] == k && !excitation.loadings[e].motion.vanishes())
        motion.ground = factor * excitation.loadings[e].motion.at(motion.angular_frequency);
    list.push_back(response::deflection_shape(machine_.system, machine_.assembled, motion));
  }
  return list;
}

double PointObserver::contact(std::size_t stop, const HarmonicBalance& balance, const SteadyPoint& point) const {
  const auto first = to_index(stop);
  for (const LawSet::Distance& one : balance.laws().distances())
    if (one.first == first) return contact_share(one.law, point.deflections.middleCols(first, 3));
  return contact_share(balance.laws().single()[stop], point.deflections.col(first),
                       point.angular_frequency * machine_.excitation.first_harmonic);
}

}  // namespace trivet::nonlinear
