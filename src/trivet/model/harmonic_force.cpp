// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/model/harmonic_force.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <variant>

#include "trivet/foundation/invalid_input.h"

namespace trivet::model {

HarmonicForce harmonic_force(const System& system, const std::string& excitation) {
  const auto& all = system.description().excitations;
  const auto found = std::ranges::find(all, excitation, &Excitation::name);
  if (found == all.end() || !std::holds_alternative<Harmonic>(found->course))
    throw foundation::InvalidInput("transmissibility: \"" + excitation +
                                   "\" is not a harmonic excitation of this model");
  const Action& action = found->action;
  if (!action.body)
    throw foundation::InvalidInput("transmissibility: \"" + excitation +
                                   "\" moves the ground; force transmissibility needs a force on a body");
  const Eigen::Vector3cd force = action.amplitude.head<3>(), moment = action.amplitude.tail<3>();
  if (force.isZero(0) == moment.isZero(0))
    throw foundation::InvalidInput("transmissibility: \"" + excitation + "\" has " +
                                   (force.isZero(0) ? "neither force nor moment" : "a force and a moment") +
                                   "; it needs exactly one of them");
  return {action, force.isZero(0) ? moment : force, force.isZero(0)};
}

Eigen::Vector3cd HarmonicForce::in_phase_with_largest() const {
  Eigen::Index largest = 0;
  vector.cwiseAbs().maxCoeff(&largest);
  return vector * std::conj(vector(largest)) / std::abs(vector(largest));
}

bool HarmonicForce::rotates() const {
  constexpr double round_off = 1e-12;  // components of other phases below this share of the force
  return in_phase_with_largest().imag().norm() > round_off * vector.norm();
}

std::string reason_without_transmission(const System& system, const std::string& excitation) {
  try {
    static_cast<void>(harmonic_force(system, excitation));
    return "";
  } catch (const foundation::InvalidInput& reason) {
    return reason.what();
  }
}

AppliedForce applied_force(const System& system, const std::string& excitation) {
  const HarmonicForce force = harmonic_force(system, excitation);
  if (force.rotates())
    throw foundation::InvalidInput("transmissibility: the components of \"" + excitation +
                                   "\" differ in phase, so its direction is not constant; give them the same phase");
  const Action& action = force.action;
  return {*action.body,
          action.at,
          {system.bodies()[*action.body].pose.rotation * force.in_phase_with_largest().real(), force.rotation}};
}

}  // namespace trivet::model
