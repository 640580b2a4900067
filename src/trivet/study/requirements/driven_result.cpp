// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/driven_result.h"

#include <cmath>
#include <utility>

namespace trivet::study {

DrivenResult::DrivenResult(const model::System& system, const assembly::Assembled& assembled, const std::string& name,
                           assembly::MotionQuantity quantity, const std::vector<std::string>& excitations)
    : assembled_(assembled),
      channel_(assembly::channels(system, assembled, {name}, quantity).front()),
      load_(assembly::harmonic_loading(system, assembled, excitations)) {}

DrivenResult::DrivenResult(const assembly::Assembled& assembled, assembly::Channel channel, assembly::Loading load)
    : assembled_(assembled), channel_(std::move(channel)), load_(std::move(load)) {}

response::Dynamics DrivenResult::at(double omega) const {
  return response::body_dynamics(
      response::dynamics(assembled_, channel_, load_, omega, response::element_jets(assembled_, omega)),
      assembled_.layout.of_bodies());
}

LogarithmicSlope logarithmic_slope(const response::Motion& motion) {
  const std::complex<double> y = motion.value[0], first = motion.value[1] / y, second = motion.value[2] / y;
  // ln|y| is the real part of ln y, whose derivatives are y′/y and y″/y − (y′/y)².
  return {std::log(std::abs(y)), first.real(), (second - first * first).real()};
}

}  // namespace trivet::study
