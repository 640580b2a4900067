// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/scalar_law.h"

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
};

struct Kinks {
  std::vector<double> operator()(const PolynomialForce&) const { return {}; }
  std::vector<double> operator()(const GapStop& law) const {
    std::vector<double> found;
    if (std::isfinite(law.gap_below)) found.push_back(-law.gap_below);
    if (std::isfinite(law.gap_above)) found.push_back(law.gap_above);
    return found;
  }
};

}  // namespace

ForceAndTangent force_and_tangent(const ScalarLaws& laws, double deflection) {
  ForceAndTangent sum;
  for (const ScalarLaw& law : laws) {
    const ForceAndTangent one = std::visit(Force{deflection}, law);
    sum.force += one.force;
    sum.tangent += one.tangent;
  }
  return sum;
}

double elastic_energy(const ScalarLaws& laws, double deflection) {
  double sum = 0;
  for (const ScalarLaw& law : laws) sum += std::visit(Energy{deflection}, law);
  return sum;
}

bool is_monotone(const ScalarLaws& laws) {
  return std::all_of(laws.begin(), laws.end(), [](const ScalarLaw& law) {
    const auto* polynomial = std::get_if<PolynomialForce>(&law);
    if (!polynomial) return true;
    for (std::size_t i = 0; i < polynomial->coefficients.size(); ++i) {
      const double c = polynomial->coefficients[i];
      const bool is_odd = i % 2 == 0;
      if (is_odd ? c < 0 : c != 0) return false;
    }
    return true;
  });
}

bool is_piecewise_linear(const ScalarLaws& laws) {
  return std::all_of(laws.begin(), laws.end(), [](const ScalarLaw& law) {
    if (const auto* stop = std::get_if<GapStop>(&law)) return stop->power == 1;
    return std::get<PolynomialForce>(law).coefficients.size() <= 1;
  });
}

std::vector<double> kinks(const ScalarLaws& laws) {
  std::vector<double> all;
  for (const ScalarLaw& law : laws) {
    const std::vector<double> of_law = std::visit(Kinks{}, law);
    all.insert(all.end(), of_law.begin(), of_law.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace trivet::elements
