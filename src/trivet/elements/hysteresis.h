// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <variant>

/// Forces that depend on the course of a deflection but not on its rate. From one turning point to the next, the force
/// is a function of the travel since the turning point and of the force there. Equations: docs/nonlinear.md.
namespace trivet::elements {

/// Spring and Coulomb friction in series (Jenkins): sticks with stiffness k until |f| = slip.
struct Slider {
  double stiffness = 0;  ///< k [N/m or N m/rad], > 0
  double slip = 0;       ///< [N or N m], > 0
};

/// Smooth friction of rubber [Berg 1998]: f = f_0 + u (±F − f_0)/(x_2 (1 ∓ f_0/F) + |u|) after the travel u.
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

using HystereticForce = std::variant<Slider, BergFriction, BoucWen>;

struct ForceOnTravel {
  double force = 0;
  double by_travel = 0;  ///< ∂f/∂u, the tangent
  double by_start = 0;   ///< ∂f/∂f_0
};
/// The force after the travel u from a turning point with the force f_0. From f_0 = 0: virgin loading.
[[nodiscard]] ForceOnTravel force_on_travel(const HystereticForce& law, double start, double travel);

/// The travel at which the force is not smooth: a slider begins to slip, a Bouc–Wen force changes its sign. In the
/// given direction (±1) from a turning point; empty if there is none.
[[nodiscard]] std::optional<double> kink_travel(const HystereticForce& law, double start, double direction);

/// Tangent of loops of vanishing amplitude.
[[nodiscard]] double initial_stiffness(const HystereticForce& law);
/// Limit of |f|.
[[nodiscard]] double force_limit(const HystereticForce& law);

}  // namespace trivet::elements
