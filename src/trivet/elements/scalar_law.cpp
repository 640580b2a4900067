// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/scalar_law.h"

#include <algorithm>
#include <cmath>

namespace trivet::elements {

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
