// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/elements/law.h"
#include "trivet/model/system.h"

namespace trivet::test {

/// A body that moves along z alone.
inline model::Body guided_body(const std::string& name, double mass) {
  model::Body body;
  body.name = name;
  body.mass.mass = mass;
  body.has_inertia = false;
  body.free = {false, false, true, false, false, false};
  return body;
}

/// A spring [N/m] with a dashpot [N s/m] along z, at the place (x, 0, 0) of both ends.
inline model::Element vertical_spring(const std::string& name, std::optional<std::size_t> from, std::size_t on,
                                      double stiffness, double dashpot = 0, double x = 0) {
  const auto along_z = [](double constant) {
    spatial::Vector6 constants = spatial::Vector6::Zero();
    constants(2) = constant;
    return elements::constants_at_point(constants, Eigen::Vector3d::Zero(), 0);
  };
  model::Element element;
  element.name = name;
  element.type = "three_springs";
  element.k.body = on;
  element.n.body = from;
  element.k.at = element.n.at = {x, 0, 0};
  element.law.nominal_stiffness = along_z(stiffness);
  if (dashpot > 0) element.law.damping = elements::DampingMatrix{along_z(dashpot)};
  return element;
}

/// "machine" of mass m on "mount": ω0 = √(k/m), damping ratio ζ.
inline model::Description guided_mass(double mass, double angular_frequency, double damping_ratio) {
  model::Description description;
  description.bodies = {guided_body("machine", mass)};
  description.elements = {vertical_spring("mount", {}, 0, mass * angular_frequency * angular_frequency,
                                          2 * damping_ratio * mass * angular_frequency)};
  return description;
}

/// A harmonic force along z at the pole of a body, times ω^power.
inline model::Excitation vertical_force(const std::string& name, std::size_t body, std::complex<double> amplitude,
                                        int power = 0) {
  model::Action action;
  action.body = body;
  action.amplitude(2) = amplitude;
  return {name, action, model::Harmonic{power}};
}

}  // namespace trivet::test
