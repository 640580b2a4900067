// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
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
/// gap g' below, 0 between them. p = 1.5: Hertz. Or, in place of k (…)^p, a curve over the travel beyond the gap.
/// Damping acts only in contact and never pulls: the force is multiplied by max(0, 1 + b v), with the rate v at which
/// the stop closes. [Hunt, Crossley, J. Appl. Mech. 42 (1975)]
struct GapStop {
  static constexpr double none = std::numeric_limits<double>::infinity();
  double gap_above = none;                                      ///< g
  double gap_below = none;                                      ///< g'
  double stiffness = std::numeric_limits<double>::quiet_NaN();  ///< k [N/m^p], > 0
  double power = 1;                                             ///< p ≥ 1
  double dissipation = 0;                                       ///< b [s/m or s/rad], ≥ 0
  bool gaps_at_rest = false;                                    ///< gaps are those of the machine at rest
  double counted_from = 0;                                      ///< deflection from which gaps are counted
  std::optional<KnotCurve> curve = {};                          ///< from (0, 0), never falling, in place of k and p

  [[nodiscard]] double upper() const { return counted_from + gap_above; }  ///< deflection at which it closes
  [[nodiscard]] double lower() const { return counted_from - gap_below; }
};

/// f through points; f(0) = 0.
struct ForceCurve {
  KnotCurve force;
  bool rises = false;       ///< the force never falls
  bool is_limited = false;  ///< no motion may leave its points
};

/// Gas behind an area: f = −(p (V/(V + A δ))^n − p_a) A. δ < 0 compresses it.
struct GasForce {
  double pressure = 0;    ///< p at δ = 0, absolute [Pa], > 0
  double volume = 0;      ///< V at δ = 0 [m³], > 0
  double area = 0;        ///< A [m²], > 0
  double exponent = 1;    ///< n ≥ 1; 1: isothermal
  double atmosphere = 0;  ///< p_a [Pa], ≥ 0
};

using ElasticForce = std::variant<PolynomialForce, GapStop, ForceCurve, GasForce>;

struct ForceAndTangent {
  double force = 0;
  double tangent = 0;  ///< df/dδ; at a kink that of larger |δ|
};
[[nodiscard]] ForceAndTangent force_and_tangent(const ElasticForce& law, double deflection);

/// The same while δ changes at a rate, with the damping of stops.
struct ForceInMotion {
  double force = 0, by_deflection = 0, by_rate = 0;
};
[[nodiscard]] ForceInMotion force_in_motion(const ElasticForce& law, double deflection, double rate);
struct ForcesInMotion {
  Eigen::VectorXd force, by_deflection, by_rate;
};
/// Adds them at many deflections, each with its rate. All vectors have one length.
void add_forces_in_motion(const ElasticForce& law, const Eigen::VectorXd& deflections, const Eigen::VectorXd& rates,
                          ForcesInMotion& sums);
/// Is it linear in δ at each rate, and in the rate at each δ, between kinks?
[[nodiscard]] bool is_piecewise_bilinear(const ElasticForce& law);
/// ∂²f/∂δ∂v of such a force.
[[nodiscard]] double mixed_derivative(const ElasticForce& law, double deflection, double rate);
/// Does its force depend on the rate?
[[nodiscard]] bool is_damped(const ElasticForce& law);
/// Rates at which that dependence is not smooth.
[[nodiscard]] std::vector<double> rate_kinks(const ElasticForce& law);

/// ∫ f dδ from 0 [J], without damping.
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
