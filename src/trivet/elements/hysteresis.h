// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <variant>
#include <vector>

/// Forces that depend on the course of a deflection but not on its rate. From one turning point to the next, the force
/// is a function of the travel since the turning point and of the force there. Equations: docs/nonlinear.md.
namespace trivet::elements {

/// Spring and Coulomb friction in series (Jenkins): sticks with stiffness k until |f| = breakaway, slips with |f| =
/// slip.
struct Slider {
  double stiffness = 0;  ///< k [N/m or N m/rad], > 0
  double slip = 0;       ///< kinetic limit [N or N m], > 0
  double breakaway = 0;  ///< static limit; that of slip if it is smaller

  [[nodiscard]] double limit() const { return breakaway > slip ? breakaway : slip; }
};

/// Coulomb friction without a spring, between motion in one sense and in the other: |f| = slip. Its deflection may not
/// rest; where it turns at once, f jumps.
struct CoulombFriction {
  double slip = 0;       ///< kinetic limit [N or N m], > 0
  double breakaway = 0;  ///< static limit; that of slip if it is smaller

  [[nodiscard]] double limit() const { return breakaway > slip ? breakaway : slip; }
};

/// Smooth friction of rubber [Berg 1998]: f = f_0 + |u| (±F − f_0)/(x_2 (1 ∓ f_0/F) + |u|) after the travel u.
struct BergFriction {
  double force = 0;       ///< F, the limit of |f| [N or N m], > 0
  double deflection = 0;  ///< x_2: virgin loading has half of F there [m or rad], > 0
};

/// f = F z, dz/du = (k/F) (1 − (γ + β sgn(z du) + φ (sgn z + sgn du)) |z|^n). [Bouc 1967; Wen 1976; φ: Wang, Wen, J.
/// Eng. Mech. 126 (2000)]
struct BoucWen {
  double stiffness = 0;  ///< k at z = 0 [N/m or N m/rad], > 0
  double force = 0;      ///< F [N or N m], > 0
  double exponent = 1;   ///< n ≥ 1
  double beta = 0.5;     ///< β > 0
  double gamma = 0.5;    ///< −β < γ ≤ β: no loop feeds energy
  double asymmetry = 0;  ///< φ; 2 |φ| < β + γ: the limits of f are F (β + γ ± 2φ)^(−1/n)
};

using HystereticForce = std::variant<Slider, BergFriction, BoucWen, CoulombFriction>;

struct ForceOnTravel {
  double force = 0;
  double by_travel = 0;  ///< ∂f/∂u, the tangent
  double by_start = 0;   ///< ∂f/∂f_0
};
/// The force after the travel u from a turning point with the force f_0.
[[nodiscard]] ForceOnTravel force_on_travel(const HystereticForce& law, double start, double travel);

/// The force after the first deflection of all (virgin loading), under which friction has its kinetic limit. Friction
/// without a spring has any force within its limits at rest; here none, as after vibration.
[[nodiscard]] ForceOnTravel virgin_force(const HystereticForce& law, double deflection);
/// Deflections at which that is not smooth.
[[nodiscard]] std::vector<double> virgin_kinks(const HystereticForce& law);

/// By how much the force changes at once, in the direction of the travel: where it is not smooth, and at a turning
/// point with the force f_0.
[[nodiscard]] double jump_at_kink(const HystereticForce& law, double direction);
[[nodiscard]] double jump_at_turn(const HystereticForce& law, double start, double direction);

/// Does it jump at turning points: is it friction without a spring?
[[nodiscard]] bool jumps_at_turns(const HystereticForce& law);

/// Is the tangent constant between turning points and kinks?
[[nodiscard]] bool is_piecewise_linear(const HystereticForce& law);

/// Tangent of loops of vanishing amplitude; none of friction without a spring, which sticks.
[[nodiscard]] double initial_stiffness(const HystereticForce& law);
/// Limit of |f|.
[[nodiscard]] double force_limit(const HystereticForce& law);

}  // namespace trivet::elements
