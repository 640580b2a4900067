// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/elements/amplitude_force.h"
#include "trivet/elements/damping_force.h"
#include "trivet/elements/elastic_force.h"
#include "trivet/elements/hysteresis.h"
#include "trivet/elements/lugre_friction.h"

/// Forces over one deflection δ of an element, in addition to its 12×12: along or about one axis, in N over m or N m
/// over rad. Positive forces act against positive deflections. Equations and sources: docs/nonlinear.md.
namespace trivet::elements {

using ScalarLaw = std::variant<ElasticForce, DampingForce, HystereticForce, PayneForce, LuGreFriction>;
/// Forces over the same deflection add up.
using ScalarLaws = std::vector<ScalarLaw>;

/// Force of a slow deflection from 0: hysteretic parts and bristles under virgin loading, parts that depend on the
/// amplitude as at the turning points of that amplitude.
[[nodiscard]] ForceAndTangent force_at_rest(const ScalarLaws& laws, double deflection);

/// What the laws are for motions of vanishing amplitude about a deflection: hysteretic parts and bristles stick, but
/// for friction without a spring, which is left out.
struct SmallMotion {
  double stiffness = 0;  ///< [N/m or N m/rad]
  double damping = 0;    ///< [N s/m or N m s/rad]
};
[[nodiscard]] SmallMotion small_motion(const ScalarLaws& laws, double deflection);

/// ∫ f dδ from 0 of the elastic parts [J].
[[nodiscard]] double elastic_energy(const ScalarLaws& laws, double deflection);

/// Does the force at rest never fall as the deflection grows? False also if it is not known.
[[nodiscard]] bool is_monotone(const ScalarLaws& laws);

/// Deflections at which the force at rest is not smooth, ascending.
[[nodiscard]] std::vector<double> kinks_at_rest(const ScalarLaws& laws);

/// The laws of one kind.
template <typename Kind>
[[nodiscard]] std::vector<Kind> only(const ScalarLaws& laws) {
  std::vector<Kind> found;
  for (const ScalarLaw& law : laws)
    if (const auto* one = std::get_if<Kind>(&law)) found.push_back(*one);
  return found;
}

}  // namespace trivet::elements
