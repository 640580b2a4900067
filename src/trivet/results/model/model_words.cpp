// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/model/model_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "trivet/documents/text_table.h"
#include "trivet/foundation/significant_digits.h"
#include "trivet/results/format/in_documents.h"

namespace trivet::results {

namespace {

std::string n(double value) { return number_text(value, 6); }

/// With the prefix of its unit: "243.7 kN/m".
std::string q(double value, const std::string& unit) { return foundation::prefixed_exactly(value, unit, 6); }

/// Over a deflection [m] or an angle [rad].
struct LawWords {
  std::string force, length;

  std::string operator()(const elements::PolynomialForce& law) const {
    std::string sum;
    for (std::size_t i = 0; i < law.coefficients.size(); ++i)
      if (const double c = law.coefficients[i]; c != 0)
        sum += fmt::format("{}{} {}",
                           sum.empty() ? ""
                               : c < 0 ? " − "
                                       : " + ",
                           n(sum.empty() ? c : std::abs(c)), i == 0 ? "δ" : fmt::format("δ^{}", i + 1));
    return fmt::format("polynomial: {} [{}], δ in {}", sum.empty() ? "0" : sum, force, length);
  }
  std::string operator()(const elements::GapStop& law) const {
    std::string words = "gap stop:";
    if (std::isfinite(law.gap_above)) words += fmt::format(" gap {},", q(law.gap_above, length));
    if (std::isfinite(law.gap_below)) words += fmt::format(" gap below {},", q(law.gap_below, length));
    if (law.gaps_at_rest) words += " from rest,";
    if (law.curve)
      words +=
          fmt::format(" curve of {} points over {}", law.curve->knots().size(), q(law.curve->knots().back(), length));
    else words += " " + (law.power == 1 ? q(law.stiffness, slope()) : n(law.stiffness) + " " + slope());
    if (law.power != 1) words += fmt::format("^{0}, power {0}", n(law.power));
    if (law.dissipation > 0) words += fmt::format(", dissipation {} s/{}", n(law.dissipation), length);
    return words;
  }
  std::string operator()(const elements::ForceCurve& law) const {
    const std::vector<double>& x = law.force.knots();
    return fmt::format("curve: {} points from {} to {}{}", x.size(), q(x.front(), length), q(x.back(), length),
                       law.is_limited ? ", known there only" : "");
  }
  std::string operator()(const elements::GasForce& law) const {
    return fmt::format("gas: {}, {} m³, {} m², exponent {}, atmosphere {}", q(law.pressure, "Pa"), n(law.volume),
                       n(law.area), n(law.exponent), q(law.atmosphere, "Pa"));
  }
  std::string operator()(const elements::ElasticForce& law) const { return std::visit(*this, law); }
  std::string operator()(const elements::QuadraticDamping& law) const {
    if (law.above == law.below) return fmt::format("damper: {} v |v| [{}], v in {}/s", n(law.above), force, length);
    return fmt::format("damper: {} v² above, {} v² below [{}], v in {}/s", n(law.above), n(law.below), force, length);
  }
  std::string operator()(const elements::DampingCurve& law) const {
    const std::vector<double>& v = law.force.knots();
    if (v.size() == 2 && law.force.at(0).value == 0) return "damper: " + q(law.force.at(0).slope, rate());
    return fmt::format("damping curve: {} points from {} to {}", v.size(), q(v.front(), length + "/s"),
                       q(v.back(), length + "/s"));
  }
  std::string operator()(const elements::DampingForce& law) const { return std::visit(*this, law); }
  std::string operator()(const elements::Slider& law) const {
    return fmt::format("friction: slips at {}{}, sticks with {}", q(law.slip, force), static_limit(law),
                       q(law.stiffness, slope()));
  }
  std::string operator()(const elements::CoulombFriction& law) const {
    return fmt::format("friction: slips at {}{}, without a spring", q(law.slip, force), static_limit(law));
  }
  std::string operator()(const elements::BergFriction& law) const {
    return fmt::format("Berg's friction: {}, half of it at {}", q(law.force, force), q(law.deflection, length));
  }
  std::string operator()(const elements::BoucWen& law) const {
    std::string words = fmt::format("Bouc–Wen: {}, force {}, n = {}, β = {}, γ = {}", q(law.stiffness, slope()),
                                    q(law.force, force), n(law.exponent), n(law.beta), n(law.gamma));
    return law.asymmetry == 0 ? words : words + fmt::format(", asymmetry {}", n(law.asymmetry));
  }
  std::string operator()(const elements::HystereticForce& law) const { return std::visit(*this, law); }
  std::string operator()(const elements::PayneForce& law) const {
    return fmt::format("rubber over amplitude: stiffness falls by {}, loss up to {}, amplitude {}, exponent {}",
                       q(law.stiffness, slope()), q(law.loss, slope()), q(law.amplitude, length), n(law.exponent));
  }
  std::string operator()(const elements::LuGreFriction& law) const {
    std::string words =
        fmt::format("LuGre: slips at {}{}, bristles {}, damping {}, viscous {}", q(law.slip, force), static_limit(law),
                    q(law.stiffness, slope()), q(law.damping, rate()), q(law.viscous, rate()));
    return law.breakaway > law.slip
        ? words + fmt::format(", Stribeck velocity {}", q(law.stribeck_velocity, length + "/s"))
        : words;
  }

 private:
  [[nodiscard]] std::string slope() const { return force + "/" + length; }
  [[nodiscard]] std::string rate() const { return force + " s/" + length; }
  template <typename Law>
  [[nodiscard]] std::string static_limit(const Law& law) const {
    return law.breakaway > law.slip ? fmt::format(" (static {})", q(law.breakaway, force)) : "";
  }
};

std::string friction_words(const elements::RubbingFriction& law) {
  return fmt::format("friction: up to {} of the force that presses it, sticks with {}", n(law.coefficient),
                     q(law.stiffness, "N/m"));
}

std::string place_of(const model::Element& element, const model::NonlinearPart& part) {
  if (part.is_inner())
    return fmt::format("law of its {}, over the volume per area of the piston, as a force on it",
                       element.law.inner->names[static_cast<std::size_t>(part.inner)]);
  return fmt::format("law {} {}", part.is_rotation() ? "about" : "along", "xyz"[part.axis % 3]);
}

}  // namespace

std::vector<model::Fact> law_facts(const model::Element& element) {
  std::vector<model::Fact> facts;
  for (const model::NonlinearPart& part : element.nonlinear_parts) {
    // Of a mount over large deformations the second law takes its linear one off.
    const bool follows = element.over_deflection && &part == &element.nonlinear_parts.front();
    for (std::size_t i = 0; i < part.laws.size(); ++i) {
      if (follows && i == 1) continue;
      const LawWords words = part.is_rotation() ? LawWords{"N m", "rad"} : LawWords{"N", "m"};
      facts.push_back({place_of(element, part), std::visit(words, part.laws[i])});
    }
  }
  for (const model::DistancePart& part : element.distance_parts) {
    for (const elements::ScalarLaw& law : part.law.laws)
      facts.push_back(
          {part.law.across ? "law across its axis" : "law over its length", std::visit(LawWords{"N", "m"}, law)});
    if (!part.law.across) facts.push_back({"length without force", q(part.law.length, "m")});
    if (part.friction) facts.push_back({"around and along its wall", friction_words(*part.friction)});
  }
  for (const model::RubbingPart& part : element.rubbing_parts)
    facts.push_back({"across its axis", friction_words(part.law)});
  return facts;
}

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
