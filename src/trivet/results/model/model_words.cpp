// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/model/model_words.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace trivet::results {

std::string damping_words(const elements::Damping& damping) {
  if (const auto* p = std::get_if<elements::ProportionalDamping>(&damping))
    return fmt::format("B = {:.6g} s × {} K", p->factor, p->of_nominal ? "nominal" : "scaled");
  if (const auto* l = std::get_if<elements::LossFactor>(&damping)) return fmt::format("loss factor {:.6g}", l->value);
  if (const auto* v = std::get_if<elements::Viscoelastic>(&damping)) return elements::law_description(*v);
  return std::holds_alternative<elements::DampingMatrix>(damping) ? "viscous matrix" : "none";
}

std::string damping_words(const model::SystemDamping& damping) {
  if (const auto* r = std::get_if<model::RayleighDamping>(&damping))
    return fmt::format("B += {:.6g} 1/s × A + {:.6g} s × K", r->mass, r->stiffness);
  if (const auto* m = std::get_if<model::ModalDamping>(&damping)) {
    std::string ratios;
    for (const double ratio : m->ratios) ratios += fmt::format("{}{:.6g}", ratios.empty() ? "" : ", ", ratio);
    return "modal damping ratios " + ratios;
  }
  return "only that of the elements";
}

namespace {

const char* type_of(const model::Excitation& excitation) {
  if (const auto* harmonic = std::get_if<model::Harmonic>(&excitation.course))
    return harmonic->power_of_frequency == 2 ? "unbalance" : excitation.action.body ? "harmonic" : "base";
  if (std::holds_alternative<model::Orders>(excitation.course)) return "orders";
  return std::holds_alternative<model::Random>(excitation.course) ? "random" : "time";
}

/// Units of the first three and of the last three components.
std::pair<std::string, std::string> units_of(const model::Excitation& excitation) {
  static constexpr std::array<const char*, 3> translation = {"m", "m/s", "m/s²"}, rotation = {"rad", "rad/s", "rad/s²"};
  const auto derivative = static_cast<std::size_t>(excitation.action.derivative);
  if (!excitation.action.body) return {translation[derivative], rotation[derivative]};
  const auto* harmonic = std::get_if<model::Harmonic>(&excitation.course);
  if (!harmonic) return {"1", "m"};
  if (harmonic->power_of_frequency == 2) return {"kg m", "kg m²"};
  return {"N", "N m"};
}

}  // namespace

ExcitationNumbers excitation_numbers(const model::Excitation& excitation) {
  const model::Action::Amplitude& amplitude = excitation.action.amplitude;
  const bool real = amplitude.imag().isZero(0);
  const Eigen::VectorXd size = real ? Eigen::VectorXd(amplitude.real()) : Eigen::VectorXd(amplitude.cwiseAbs());
  const auto [linear_unit, angular_unit] = units_of(excitation);
  return {.type = type_of(excitation),
          .linear = size.head(3),
          .angular = size.tail(3),
          .linear_unit = linear_unit,
          .angular_unit = angular_unit,
          .phase = real ? Eigen::VectorXd(Eigen::VectorXd::Zero(6)) : Eigen::VectorXd(amplitude.cwiseArg())};
}

}  // namespace trivet::results
