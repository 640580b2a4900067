// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "trivet/elements/knot_curve.h"

/// Forces that are functions of the rate v of a deflection, against it.
namespace trivet::elements {

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

}  // namespace trivet::elements
