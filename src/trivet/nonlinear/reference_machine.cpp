// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/reference_machine.h"

#include "trivet/assembly/channels.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/pivoted_lu.h"

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
                   Eigen::VectorXd::Zero(assembled.ground.size()), LawAbout({})};
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

bool holds_at_rest(const model::System& given) {
  constexpr double singular = 1e-13;
  const assembly::Assembled assembled = assembly::assemble(with_references(given, tangents_at_rest(given)));
  return numerics::PivotedLu<double>(assembled.matrices.K).reciprocal_condition() > singular;
}

References references_of(const model::System& given, bool holds) {
  return holds && !has_slack_dampers(given) ? tangents_at_rest(given) : positive_references(given);
}

}  // namespace trivet::nonlinear
