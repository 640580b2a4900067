// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "trivet/elements/elastic_force.h"
#include "trivet/elements/friction.h"
#include "trivet/elements/hysteresis.h"
#include "trivet/elements/knot_curve.h"

namespace trivet::elements {

// Forces that depend on the amplitude of a periodic deflection. They are known for steady motion only.

/// Stiffness and loss of filled rubber over the amplitude A [Kraus 1984], in addition to those at large amplitudes:
/// k' = Δ/(1 + (A/A_c)^2m),  k'' = 2 L (A/A_c)^m/(1 + (A/A_c)^2m).
/// The loss has its largest value L at A_c, and vanishes for small and for large amplitudes.
struct PayneForce {
  double stiffness = 0;   ///< Δ: k' of small amplitudes less that of large ones [N/m or N m/rad], ≥ 0
  double loss = 0;        ///< L [N/m or N m/rad], ≥ 0
  double amplitude = 0;   ///< A_c [m or rad], > 0
  double exponent = 0.6;  ///< m, > 0
};

/// Complex stiffness k' + i k'' and its derivative by the amplitude.
struct StiffnessOfAmplitude {
  double storage = 0, loss = 0, storage_slope = 0, loss_slope = 0;
};
/// @param amplitude  ≥ 0; slopes at 0 are those just above it
[[nodiscard]] StiffnessOfAmplitude stiffness_at(const PayneForce& law, double amplitude);

// Forces that are functions of the rate v of a deflection, against it.

/// f = c v |v|, with a coefficient for either sense.
struct QuadraticDamping {
  double above = 0;  ///< for v > 0 [N s²/m² or N m s²/rad²], ≥ 0
  double below = 0;  ///< for v < 0
};

/// f through points (v, f) that contain (0, 0).
struct DampingCurve {
  KnotCurve force;
};

using DampingForce = std::variant<QuadraticDamping, DampingCurve>;

struct ForceOfRate {
  double force = 0;
  double by_rate = 0;  ///< df/dv; at a kink that of larger |v|
};
[[nodiscard]] ForceOfRate force_of_rate(const DampingForce& law, double rate);

/// Mean of df/dv on both sides of v = 0.
[[nodiscard]] double damping_at_rest(const DampingForce& law);
/// Is df/dv constant between kinks?
[[nodiscard]] bool is_piecewise_linear(const DampingForce& law);
/// Is f of second degree between kinks? Then also d²f/dv².
[[nodiscard]] bool is_piecewise_quadratic(const DampingForce& law);
[[nodiscard]] double curvature(const DampingForce& law, double rate);
/// Rates at which the force is not smooth, ascending.
[[nodiscard]] std::vector<double> kinks(const DampingForce& law);

// Forces over one deflection δ of an element, in addition to its 12×12: along or about one axis, in N over m or N m
// over rad. Positive forces act against positive deflections. Equations and sources: docs/nonlinear.md.

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
