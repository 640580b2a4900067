// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/response/transient/transient.h"

namespace trivet::test {

/// A signal times a force and moment at the pole of a body, body axes.
[[nodiscard]] inline response::TimeInput force_on(const assembly::Assembled& assembled, std::size_t body,
                                                  const excitation::Signal& signal, const spatial::Vector6& wrench,
                                                  double delay = 0) {
  model::Action action;
  action.body = body;
  action.amplitude = wrench.cast<std::complex<double>>();
  action.delay = delay;
  return {"force", signal, assembly::loading(assembled, action)};
}

/// A signal as motion of the whole ground about its origin, or of single ground ends; with derivative 2 it is an
/// acceleration.
[[nodiscard]] inline response::TimeInput base_motion(const assembly::Assembled& assembled,
                                                     const excitation::Signal& signal, const spatial::Vector6& motion,
                                                     int derivative = 0, const std::vector<std::size_t>& elements = {},
                                                     double delay = 0) {
  model::Action action;
  action.amplitude = motion.cast<std::complex<double>>();
  action.derivative = derivative;
  action.elements = elements;
  action.delay = delay;
  return {"base", signal, assembly::loading(assembled, action)};
}

[[nodiscard]] inline response::TransientResponse transient(
    const model::System& system, const assembly::Assembled& assembled, const std::vector<std::string>& of,
    const std::vector<response::TimeInput>& inputs, const response::TransientOptions& options,
    assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement) {
  return response::transient_response(system, assembled, assembly::channels(system, assembled, of, quantity), inputs,
                                      options);
}

[[nodiscard]] inline const response::TimeCurve& curve(const response::TransientResponse& response,
                                                      const std::string& name) {
  for (const response::TimeCurve& each : response.curves)
    if (each.name == name) return each;
  throw std::out_of_range("no curve " + name);
}

/// A vector of six components, one of them 1.
[[nodiscard]] inline spatial::Vector6 along(int component, double value = 1) {
  return value * spatial::Vector6::Unit(component);
}

}  // namespace trivet::test
