// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/elastic_force.h"

#include <algorithm>
#include <cmath>

namespace trivet::elements {
namespace {

/// Force, tangent and energy of one stop at a penetration ≥ 0.
struct Contact {
  double force = 0, tangent = 0, energy = 0;
};

Contact contact(const GapStop& stop, double penetration) {
  if (penetration <= 0) return {};
  if (stop.power == 1)
    return {stop.stiffness * penetration, stop.stiffness, stop.stiffness * penetration * penetration / 2};
  const double slope = stop.stiffness * std::pow(penetration, stop.power - 1), force = slope * penetration;
  return {force, stop.power * slope, force * penetration / (stop.power + 1)};
}

/// Of both stops; a force of the lower one is negative.
Contact contacts(const GapStop& stop, double deflection) {
  const Contact above = contact(stop, deflection - stop.gap_above), below = contact(stop, -deflection - stop.gap_below);
  return {above.force - below.force, above.tangent + below.tangent, above.energy + below.energy};
}

struct Force {
  double deflection;
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

double elastic_energy(const ElasticForce& law, double deflection) { return std::visit(Energy{deflection}, law); }

bool is_monotone(const ElasticForce& law) {
  if (const auto* curve = std::get_if<ForceCurve>(&law)) return curve->rises;
  const auto* polynomial = std::get_if<PolynomialForce>(&law);
  if (!polynomial) return true;
  for (std::size_t i = 0; i < polynomial->coefficients.size(); ++i) {
    const double c = polynomial->coefficients[i];
    const bool is_odd = i % 2 == 0;
    if (is_odd ? c < 0 : c != 0) return false;
  }
  return true;
}

bool is_piecewise_linear(const ElasticForce& law) {
  if (const auto* stop = std::get_if<GapStop>(&law)) return stop->power == 1;
  if (const auto* curve = std::get_if<ForceCurve>(&law)) return curve->interpolation == Interpolation::linear;
  return std::get<PolynomialForce>(law).coefficients.size() <= 1;
}

std::vector<double> kinks(const ElasticForce& law) {
  std::vector<double> found;
  if (const auto* stop = std::get_if<GapStop>(&law)) {
    if (std::isfinite(stop->gap_below)) found.push_back(-stop->gap_below);
    if (std::isfinite(stop->gap_above)) found.push_back(stop->gap_above);
  }
  if (const auto* curve = std::get_if<ForceCurve>(&law)) found = curve->force.knots();
  return found;
}

std::pair<double, double> range(const ElasticForce& law) {
  constexpr double everywhere = std::numeric_limits<double>::infinity();
  const auto* curve = std::get_if<ForceCurve>(&law);
  if (!curve || !curve->is_limited) return {-everywhere, everywhere};
  return {curve->force.knots().front(), curve->force.knots().back()};
}

}  // namespace trivet::elements
