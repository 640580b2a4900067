// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "trivet/elements/knot_curve.h"

/// Forces that are functions of a deflection δ. Equations and sources: docs/nonlinear.md.
namespace trivet::elements {

/// f = Σ c_i δ^i, i = 1, 2, …
struct PolynomialForce {
  std::vector<double> coefficients;  ///< c_1, c_2, … [N/m, N/m², …]
};

/// Elastic stops at one or both ends of a gap: f = k (δ − g)^p beyond the gap g above, f = −k (−g' − δ)^p beyond the
/// gap g' below, 0 between them. p = 1.5: Hertz.
struct GapStop {
  static constexpr double none = std::numeric_limits<double>::infinity();
  double gap_above = none;                                      ///< g; negative: it bears at δ = 0
  double gap_below = none;                                      ///< g'
  double stiffness = std::numeric_limits<double>::quiet_NaN();  ///< k [N/m^p], > 0
  double power = 1;                                             ///< p ≥ 1
};

/// f through points; f(0) = 0.
struct ForceCurve {
  KnotCurve force;
  Interpolation interpolation = Interpolation::linear;
  bool rises = false;       ///< the force never falls
  bool is_limited = false;  ///< no motion may leave its points
};

using ElasticForce = std::variant<PolynomialForce, GapStop, ForceCurve>;

struct ForceAndTangent {
  double force = 0;
  double tangent = 0;  ///< df/dδ; at a kink that of larger |δ|
};
[[nodiscard]] ForceAndTangent force_and_tangent(const ElasticForce& law, double deflection);

/// ∫ f dδ from 0 [J].
[[nodiscard]] double elastic_energy(const ElasticForce& law, double deflection);

/// Does the force never fall as the deflection grows? False also if it is not known.
[[nodiscard]] bool is_monotone(const ElasticForce& law);
/// Is the tangent constant between kinks?
[[nodiscard]] bool is_piecewise_linear(const ElasticForce& law);

/// Deflections at which the force is not smooth, ascending.
[[nodiscard]] std::vector<double> kinks(const ElasticForce& law);

/// Deflections for which the force is known.
[[nodiscard]] std::pair<double, double> range(const ElasticForce& law);

}  // namespace trivet::elements
