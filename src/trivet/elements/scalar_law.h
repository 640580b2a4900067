// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <variant>
#include <vector>

/// Forces over one deflection δ of an element, in addition to its 12×12: along or about one axis, in N over m or N m
/// over rad. Positive forces act against positive deflections. Equations and sources: docs/nonlinear.md.
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

using ScalarLaw = std::variant<PolynomialForce, GapStop>;
/// Forces over the same deflection add up.
using ScalarLaws = std::vector<ScalarLaw>;

struct ForceAndTangent {
  double force = 0;
  double tangent = 0;  ///< df/dδ; at a kink that of larger |δ|
};
[[nodiscard]] ForceAndTangent force_and_tangent(const ScalarLaws& laws, double deflection);

/// ∫ f dδ from 0 [J].
[[nodiscard]] double elastic_energy(const ScalarLaws& laws, double deflection);

/// Does the force never fall as the deflection grows? False also if it is not known.
[[nodiscard]] bool is_monotone(const ScalarLaws& laws);
/// Is the tangent constant between kinks?
[[nodiscard]] bool is_piecewise_linear(const ScalarLaws& laws);

/// Deflections at which the force is not smooth, ascending.
[[nodiscard]] std::vector<double> kinks(const ScalarLaws& laws);

}  // namespace trivet::elements
