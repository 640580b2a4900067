// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/nearest_to_line.h"

#include <cmath>
#include <utility>

#include "trivet/foundation/invalid_input.h"

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

ComparedPlace nearest_to_line(const DrivenResult& driven, const assembly::LimitLine& line, const assembly::Band& band,
                              const ComparedPlace& place) {
  constexpr double beside = 1e-5;  // to measure the slope of the line, straight on logarithmic axes
  constexpr double near = 1e-3;    // the search by values was nearer
  constexpr double settled = 1e-13;
  constexpr int most_steps = 6;
  const double start = place.angular_frequency;
  const double below = start * (1 - beside), above = start * (1 + beside);
  if (below <= band.from || above >= band.to) return place;
  const double exponent =
      std::log(response::zero_to_peak_limit(line, above) / response::zero_to_peak_limit(line, below)) /
      std::log(above / below);
  double omega = start;
  for (int i = 0; i < most_steps; ++i) {
    try {
      const LogarithmicSlope slope = logarithmic_slope(response::motion(driven.at(omega)));
      const double first = slope.first - exponent / omega, second = slope.second + exponent / (omega * omega);
      const double step = -first / second;
      if (!(second < 0) || !(std::abs(omega + step - start) <= near * start)) return place;  // no smooth maximum
      omega += step;
      if (std::abs(step) > settled * omega) continue;
      const double level = std::exp(logarithmic_slope(response::motion(driven.at(omega))).value);
      return {omega, response::zero_to_peak_limit(line, omega) / level};
    } catch (const foundation::NotComputable&) {  // an undamped resonance
      return place;
    }
  }
  return place;
}

}  // namespace trivet::study
