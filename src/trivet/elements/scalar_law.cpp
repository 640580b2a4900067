// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/scalar_law.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trivet::elements {

/// With p = (A/A_c)^m: k' = Δ/(1 + p²), k'' = 2 L p/(1 + p²), dp/dA = m p/A.
StiffnessOfAmplitude stiffness_at(const PayneForce& law, double amplitude) {
  const double ratio = std::max(amplitude / law.amplitude, std::numeric_limits<double>::min());
  const double p = std::pow(ratio, law.exponent), below = 1 + p * p,
               by_amplitude = law.exponent * p / (ratio * law.amplitude);
  return {law.stiffness / below, 2 * law.loss * p / below, -2 * law.stiffness * p / (below * below) * by_amplitude,
          2 * law.loss * (1 - p * p) / (below * below) * by_amplitude};
}

ForceOfRate force_of_rate(const DampingForce& law, double rate) {
  if (const auto* quadratic = std::get_if<QuadraticDamping>(&law)) {
    const double c = rate < 0 ? quadratic->below : quadratic->above, by_rate = c * std::abs(rate);
    return {by_rate * rate, 2 * by_rate};
  }
  const KnotCurve::ValueAndSlope found = std::get<DampingCurve>(law).force.at(rate);
  return {found.value, found.slope};
}

double damping_at_rest(const DampingForce& law) {
  constexpr double beside = 1e-12;  // of the largest rate of the table: either side of a knot at 0
  const auto* curve = std::get_if<DampingCurve>(&law);
  if (!curve) return 0;
  const double rate = beside * (curve->force.knots().back() - curve->force.knots().front());
  return (force_of_rate(law, rate).by_rate + force_of_rate(law, -rate).by_rate) / 2;
}

bool is_piecewise_linear(const DampingForce& law) {
  const auto* curve = std::get_if<DampingCurve>(&law);
  return curve && curve->force.is_linear();
}

bool is_piecewise_quadratic(const DampingForce& law) {
  return std::holds_alternative<QuadraticDamping>(law) || is_piecewise_linear(law);
}

double curvature(const DampingForce& law, double rate) {
  const auto* quadratic = std::get_if<QuadraticDamping>(&law);
  if (!quadratic) return 0;
  return rate < 0 ? -2 * quadratic->below : 2 * quadratic->above;
}

std::vector<double> kinks(const DampingForce& law) {
  if (const auto* curve = std::get_if<DampingCurve>(&law)) return curve->force.knots();
  return {0};
}

ForceAndTangent force_at_rest(const ScalarLaws& laws, double deflection) {
  ForceAndTangent sum;
  for (const ScalarLaw& law : laws) {
    ForceAndTangent one;
    if (const auto* elastic = std::get_if<ElasticForce>(&law)) one = force_and_tangent(*elastic, deflection);
    if (const auto* hysteretic = std::get_if<HystereticForce>(&law)) {
      const ForceOnTravel virgin = virgin_force(*hysteretic, deflection);
      one = {virgin.force, virgin.by_travel};
    }
    if (const auto* payne = std::get_if<PayneForce>(&law)) {
      const StiffnessOfAmplitude there = stiffness_at(*payne, std::abs(deflection));
      one = {there.storage * deflection, there.storage + there.storage_slope * std::abs(deflection)};
    }
    if (const auto* bristles = std::get_if<LuGreFriction>(&law)) {
      const VirginBristles virgin = virgin_force(*bristles, deflection);
      one = {virgin.force, virgin.tangent};
    }
    sum.force += one.force;
    sum.tangent += one.tangent;
  }
  return sum;
}

SmallMotion small_motion(const ScalarLaws& laws, double deflection) {
  SmallMotion sum;
  for (const ScalarLaw& law : laws) {
    if (const auto* elastic = std::get_if<ElasticForce>(&law)) {
      const ForceInMotion found = force_in_motion(*elastic, deflection, 0);
      sum.stiffness += found.by_deflection;
      sum.damping += found.by_rate;
    }
    if (const auto* hysteretic = std::get_if<HystereticForce>(&law)) sum.stiffness += initial_stiffness(*hysteretic);
    if (const auto* damping = std::get_if<DampingForce>(&law)) sum.damping += damping_at_rest(*damping);
    if (const auto* payne = std::get_if<PayneForce>(&law)) sum.stiffness += payne->stiffness;
    if (const auto* bristles = std::get_if<LuGreFriction>(&law)) {
      sum.stiffness += bristles->stiffness;
      sum.damping += bristles->damping + bristles->viscous;
    }
  }
  return sum;
}

double elastic_energy(const ScalarLaws& laws, double deflection) {
  double sum = 0;
  for (const ElasticForce& law : only<ElasticForce>(laws)) sum += elastic_energy(law, deflection);
  return sum;
}

bool is_monotone(const ScalarLaws& laws) {
  return std::ranges::all_of(laws, [](const ScalarLaw& law) {
    const auto* elastic = std::get_if<ElasticForce>(&law);
    return elastic ? is_monotone(*elastic) : !std::holds_alternative<PayneForce>(law);
  });
}

std::vector<double> kinks_at_rest(const ScalarLaws& laws) {
  std::vector<double> all;
  for (const ScalarLaw& law : laws) {
    if (const auto* elastic = std::get_if<ElasticForce>(&law)) {
      const std::vector<double> of_law = kinks(*elastic);
      all.insert(all.end(), of_law.begin(), of_law.end());
    }
    if (const auto* hysteretic = std::get_if<HystereticForce>(&law)) {
      const std::vector<double> of_law = virgin_kinks(*hysteretic);
      all.insert(all.end(), of_law.begin(), of_law.end());
    }
  }
  std::ranges::sort(all);
  all.erase(std::ranges::unique(all).begin(), all.end());
  return all;
}

}  // namespace trivet::elements
