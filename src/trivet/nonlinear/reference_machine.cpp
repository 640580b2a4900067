// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/reference_machine.h"

#include "trivet/numerics/linalg/pivoted_lu.h"

namespace trivet::nonlinear {
namespace {

PeriodicExcitation halved(PeriodicExcitation excitation) {
  excitation.first_harmonic /= 2;
  for (Eigen::Index& harmonic : excitation.harmonics) harmonic *= 2;
  return excitation;
}

}  // namespace

ReferenceMachine::ReferenceMachine(const model::System& given, const References& references,
                                   const std::vector<std::string>& excitations)
    : system(with_references(given, references)),
      assembled(assembly::assemble(system)),
      deflections(nonlinear_deflections(system, assembled, references)),
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
