// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/elastic_force.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace trivet::elements {
namespace {

/// Force, tangent and energy of one stop at a penetration ≥ 0.
struct Contact {
  double force = 0, tangent = 0, energy = 0;
};

Contact contact(const GapStop& stop, double penetration) {
  if (penetration <= 0) return {};
  if (stop.curve) {
    const KnotCurve::ValueAndSlope there = stop.curve->at(penetration);
    return {there.value, there.slope, stop.curve->integral(penetration)};
  }
  if (stop.power == 1)
    return {stop.stiffness * penetration, stop.stiffness, stop.stiffness * penetration * penetration / 2};
  const double slope = stop.stiffness * std::pow(penetration, stop.power - 1), force = slope * penetration;
  return {force, stop.power * slope, force * penetration / (stop.power + 1)};
}

/// Of both stops; a force of the lower one is negative.
Contact contacts(const GapStop& stop, double deflection) {
  const Contact above = contact(stop, deflection - stop.upper()), below = contact(stop, stop.lower() - deflection);
  return {above.force - below.force, above.tangent + below.tangent, above.energy + below.energy};
}

/// Pressure beyond that of the atmosphere times the area, and its slope. Below a thousandth of the volume, which no
/// motion may reach, it goes straight on.
ForceAndTangent push(const GasForce& gas, double deflection) {
  constexpr double least = 1e-3;
  const double wanted = 1 + gas.area * deflection / gas.volume, share = std::max(wanted, least);
  const double pressure = gas.pressure * std::pow(share, -gas.exponent);
  const double slope = gas.exponent * pressure / share * gas.area * gas.area / gas.volume;
  return {(pressure - gas.atmosphere) * gas.area + slope * (share - wanted) * gas.volume / gas.area, slope};
}

/// Linear in the travel, between the knots of its curve?
bool is_straight(const GapStop& stop) { return stop.curve ? stop.curve->is_linear() : stop.power == 1; }

struct Force {
  double deflection;
  ForceAndTangent operator()(const GasForce& law) const {
    const ForceAndTangent found = push(law, deflection);
    return {-found.force, found.tangent};
  }
  ForceAndTangent operator()(const PolynomialForce& law) const {
    ForceAndTangent sum;
    for (std::size_t i = law.coefficients.size(); i-- > 0;) {  // Horner
      sum.tangent = sum.tangent * deflection + sum.force;
      sum.force = sum.force * deflection + law.coefficients[i];
    }
    return {sum.force * deflection, sum.tangent * deflection + sum.force};
  }
  ForceAndTangent operator()(const GapStop& law) const {
    const Contact found = contacts(law, deflection);
    return {found.force, found.tangent};
  }
  ForceAndTangent operator()(const ForceCurve& law) const {
    const KnotCurve::ValueAndSlope found = law.force.at(deflection);
    return {found.value, found.slope};
  }
};

struct Energy {
  double deflection;
  double operator()(const GasForce& law) const {
    const double share = 1 + law.area * deflection / law.volume, power = 1 - law.exponent;
    const double compressed = power == 0 ? std::log(share) : std::expm1(power * std::log(share)) / power;
    return law.atmosphere * law.area * deflection - law.pressure * law.volume * compressed;
  }
  double operator()(const PolynomialForce& law) const {
    double sum = 0;
    for (std::size_t i = law.coefficients.size(); i-- > 0;)
      sum = (sum + law.coefficients[i] / static_cast<double>(i + 2)) * deflection;
    return sum * deflection;
  }
  double operator()(const GapStop& law) const { return contacts(law, deflection).energy - contacts(law, 0).energy; }
  double operator()(const ForceCurve& law) const { return law.force.integral(deflection) - law.force.integral(0); }
};

}  // namespace

ForceAndTangent force_and_tangent(const ElasticForce& law, double deflection) {
  return std::visit(Force{deflection}, law);
}

ForceInMotion force_in_motion(const ElasticForce& law, double deflection, double rate) {
  const auto* stop = std::get_if<GapStop>(&law);
  if (!stop || stop->dissipation == 0) {
    const ForceAndTangent found = force_and_tangent(law, deflection);
    return {found.force, found.tangent, 0};
  }
  const double closing = deflection > stop->upper() ? 1 : -1;
  const Contact found = contacts(*stop, deflection);
  const double factor = 1 + closing * stop->dissipation * rate;
  if (factor <= 0) return {};
  return {found.force * factor, found.tangent * factor, closing * stop->dissipation * found.force};
}

void add_forces_in_motion(const ElasticForce& law, const Eigen::VectorXd& deflections, const Eigen::VectorXd& rates,
                          ForcesInMotion& sums) {
  assert(rates.size() == deflections.size() && sums.force.size() == deflections.size());
  if (is_damped(law)) {
    for (Eigen::Index i = 0; i < deflections.size(); ++i) {
      const ForceInMotion found = force_in_motion(law, deflections(i), rates(i));
      sums.force(i) += found.force;
      sums.by_deflection(i) += found.by_deflection;
      sums.by_rate(i) += found.by_rate;
    }
    return;
  }
  std::visit(
      [&](const auto& one) {
        for (Eigen::Index i = 0; i < deflections.size(); ++i) {
          const ForceAndTangent found = Force{deflections(i)}(one);
          sums.force(i) += found.force;
          sums.by_deflection(i) += found.tangent;
        }
      },
      law);
}

bool is_piecewise_bilinear(const ElasticForce& law) {
  const auto* stop = std::get_if<GapStop>(&law);
  return stop ? is_straight(*stop) : is_piecewise_linear(law);
}

double mixed_derivative(const ElasticForce& law, double deflection, double rate) {
  if (!is_damped(law)) return 0;
  const auto& stop = std::get<GapStop>(law);
  const bool closed_above = deflection > stop.upper(), closed_below = deflection < stop.lower();
  const double closing = closed_above ? rate : -rate;
  if (!(closed_above || closed_below) || 1 + stop.dissipation * closing <= 0) return 0;
  return (closed_above ? 1 : -1) * contacts(stop, deflection).tangent * stop.dissipation;
}

bool is_damped(const ElasticForce& law) {
  const auto* stop = std::get_if<GapStop>(&law);
  return stop && stop->dissipation > 0;
}

std::vector<double> rate_kinks(const ElasticForce& law) {
  if (!is_damped(law)) return {};
  const auto& stop = std::get<GapStop>(law);
  std::vector<double> found;
  if (std::isfinite(stop.gap_above)) found.push_back(-1 / stop.dissipation);
  if (std::isfinite(stop.gap_below)) found.push_back(1 / stop.dissipation);
  return found;
}

double elastic_energy(const ElasticForce& law, double deflection) { return std::visit(Energy{deflection}, law); }

bool is_monotone(const ElasticForce& law) {
  if (const auto* curve = std::get_if<ForceCurve>(&law)) return curve->rises;
  const auto* polynomial = std::get_if<PolynomialForce>(&law);
  if (!polynomial) return true;  // stops and gas
  for (std::size_t i = 0; i < polynomial->coefficients.size(); ++i) {
    const double c = polynomial->coefficients[i];
    const bool is_odd = i % 2 == 0;
    if (is_odd ? c < 0 : c != 0) return false;
  }
  return true;
}

bool is_piecewise_linear(const ElasticForce& law) {
  if (const auto* stop = std::get_if<GapStop>(&law)) return is_straight(*stop) && stop->dissipation == 0;
  if (const auto* curve = std::get_if<ForceCurve>(&law)) return curve->force.is_linear();
  if (std::holds_alternative<GasForce>(law)) return false;
  return std::get<PolynomialForce>(law).coefficients.size() <= 1;
}

std::vector<double> kinks(const ElasticForce& law) {
  std::vector<double> found;
  if (const auto* stop = std::get_if<GapStop>(&law)) {
    const std::vector<double> beyond = stop->curve ? stop->curve->knots() : std::vector<double>{0};
    if (std::isfinite(stop->gap_below))
      for (const double travel : beyond) found.insert(found.begin(), stop->lower() - travel);
    if (std::isfinite(stop->gap_above))
      for (const double travel : beyond) found.push_back(stop->upper() + travel);
  }
  if (const auto* curve = std::get_if<ForceCurve>(&law)) found = curve->force.knots();
  return found;
}

std::pair<double, double> range(const ElasticForce& law) {
  constexpr double everywhere = std::numeric_limits<double>::infinity();
  if (const auto* gas = std::get_if<GasForce>(&law)) return {-gas->volume / gas->area, everywhere};
  const auto* curve = std::get_if<ForceCurve>(&law);
  if (!curve || !curve->is_limited) return {-everywhere, everywhere};
  return {curve->force.knots().front(), curve->force.knots().back()};
}

}  // namespace trivet::elements
