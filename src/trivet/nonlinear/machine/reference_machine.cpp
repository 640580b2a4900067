// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/machine/reference_machine.h"

#include <cmath>

#include "trivet/assembly/channels.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"

namespace trivet::nonlinear {
namespace {

PeriodicExcitation halved(PeriodicExcitation excitation) {
  excitation.first_harmonic /= 2;
  for (Eigen::Index& harmonic : excitation.harmonics) harmonic *= 2;
  return excitation;
}

std::vector<Deflection> all_deflections(const model::System& system, const assembly::Assembled& assembled,
                                        const References& references) {
  std::vector<Deflection> found = nonlinear_deflections(system, assembled, references);
  add_rubbings(system, assembled, found);
  return found;
}

std::vector<Deflection> with_displacement(const std::string& name, const model::System& system,
                                          const assembly::Assembled& assembled, std::vector<Deflection> deflections) {
  if (name.empty()) return deflections;
  const std::vector<assembly::Channel> channels =
      assembly::channels(system, assembled, {name}, assembly::MotionQuantity::displacement);
  const auto is_force = [](const assembly::Channel& one) {
    return !one.on_velocity.isZero(0) || !one.on_acceleration.isZero(0) || !one.dynamic_forces.empty();
  };
  if (channels.size() != 1 || channels[0].derivative != 0 || is_force(channels[0]))
    throw foundation::InvalidInput("steady: phase.of: " + name + " is not one displacement or rotation");
  Deflection found{name, channels[0].unit == "rad", channels[0].on_displacement.real(),
                   Eigen::VectorXd::Zero(assembled.ground.size()), DeviationLaw({})};
  found.is_followed = true;
  if (!channels[0].ground.empty()) found.on_ground = channels[0].ground.on_displacement.real();
  deflections.push_back(std::move(found));
  return deflections;
}

}  // namespace

ReferenceMachine::ReferenceMachine(const model::System& given, const References& references,
                                   const std::vector<std::string>& excitations, const std::string& without_law)
    : system(with_references(given, references)),
      assembled(assembly::assemble(system)),
      deflections(with_displacement(without_law, system, assembled, all_deflections(system, assembled, references))),
      excitation(periodic_excitation(system, assembled, excitations)),
      condensed(assembled, deflections, excitation) {}

ReferenceMachine::ReferenceMachine(const ReferenceMachine& same, TwoPeriods /*unused*/)
    : system(same.system),
      assembled(same.assembled),
      deflections(same.deflections),
      excitation(halved(same.excitation)),
      condensed(assembled, deflections, excitation) {}

namespace {

/// The softest direction with tangents and with positive references, in coordinates in which the latter have a diagonal
/// of 1. Stiffnesses that cancel leave round-off of their size, which a condition number does not show: that of one
/// coordinate is 1.
HoldAtRest hold_of(const Eigen::MatrixXd& tangent, const Eigen::MatrixXd& positive) {
  constexpr double singular = 1e-13, round_off = 1e-12, enough = 1e-9;
  if (!(numerics::PivotedLu<double>(tangent).reciprocal_condition() > singular)) return {};
  const Eigen::VectorXd scale =
      positive.diagonal().unaryExpr([](double entry) { return entry == 0 ? 1.0 : 1 / std::sqrt(std::abs(entry)); });
  const auto softest = [&](const Eigen::MatrixXd& stiffness) {
    const Eigen::MatrixXd scaled =
        scale.asDiagonal() * (0.5 * (stiffness + stiffness.transpose())) * scale.asDiagonal();
    return numerics::symmetric_eigenvalues(scaled).cwiseAbs().minCoeff();
  };
  const double share = softest(tangent) / softest(positive);
  return {share > round_off, share > enough};
}

}  // namespace

HoldAtRest hold_at_rest(const model::System& given) {
  return hold_of(assembly::assemble(with_references(given, tangents_at_rest(given))).matrices.K,
                 assembly::assemble(with_references(given, positive_references(given))).matrices.K);
}

bool holds_static_load(const model::System& given) {
  return hold_of(assembly::assemble_first_order(with_references(given, tangents_at_rest(given))).matrices.K,
                 assembly::assemble_first_order(with_references(given, positive_references(given))).matrices.K)
      .holds;
}

References references_of(const model::System& given, const HoldAtRest& hold) {
  return hold.conditions && !has_slack_dampers(given) ? tangents_at_rest(given) : positive_references(given);
}

}  // namespace trivet::nonlinear
