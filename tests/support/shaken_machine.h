// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>

#include "support/random_system.h"
#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/elements/law.h"
#include "trivet/response/steady/peaks.h"

namespace trivet::test {

/// A description with its matrices.
struct Assembly {
  model::System system;
  assembly::Assembled assembled;
  explicit Assembly(const model::Description& d) : system(checked(d)), assembled(assembly::assemble(system)) {}

  [[nodiscard]] std::vector<assembly::Channel> channels(
      const std::vector<std::string>& of,
      assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement) const {
    return assembly::channels(system, assembled, of, quantity);
  }
  [[nodiscard]] assembly::Loading loading() const { return assembly::harmonic_loading(system, assembled); }
  [[nodiscard]] response::Peaks peaks(const std::vector<assembly::Channel>& of) const {
    const modal::Modes modes = modal::modes(system, assembled);
    return response::peaks(assembled, of, loading(), modes, modal::roots(system, assembled, modes));
  }
};

/// The same machine on a foundation with a translation given by its acceleration a, and on a foundation at rest under
/// the inertial forces −m a. The motion relative to the ground in the first is the motion in the second, which has no
/// moving ground.
struct ShakenAndPushed {
  model::Description shaken, pushed;
  std::vector<std::string> relative, plain;  ///< results of the first and of the second, in the same order

  ShakenAndPushed(const model::Description& machine, const Eigen::Vector3cd& acceleration)
      : shaken(machine), pushed(machine) {
    shaken.excitations.clear();
    pushed.excitations.clear();
    model::Excitation base{"base", {}, model::Harmonic{}};
    base.action.derivative = 2;
    base.action.amplitude.head<3>() = acceleration;
    shaken.excitations.push_back(base);
    for (std::size_t b = 0; b < machine.bodies.size(); ++b) {
      const model::Body& body = machine.bodies[b];
      model::Excitation inertia{"inertia " + std::to_string(b), {}, model::Harmonic{}};
      inertia.action.body = b;
      inertia.action.at = body.mass.centre;
      inertia.action.amplitude.head<3>() =
          -body.mass.mass * (body.pose.rotation.transpose().cast<std::complex<double>>() * acceleration);
      pushed.excitations.push_back(inertia);
      relative.push_back(body.name + ".relative");
      plain.push_back(body.name);
    }
    for (const model::Element& element : machine.elements)
      for (std::vector<std::string>* of : {&relative, &plain}) of->push_back(element.name + ".deflection");
  }
};

/// Gives every element proportional damping with which the lowest mode would have the damping ratio `times`.
inline void overdamp(model::Description& d, double times) {
  double lowest = 1e300;
  for (const modal::Mode& mode : modal::modes(checked(d)).list)
    lowest = std::min(lowest, mode.angular_frequency.value_or(lowest));
  for (model::Element& element : d.elements)
    element.law.damping = elements::ProportionalDamping{2 * times / lowest, false};
}

}  // namespace trivet::test
