// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "trivet/elements/saturation.h"

namespace trivet::elements {

// Forces that depend on the course of a deflection but not on its rate. From one turning point to the next, the force
// is a function of the travel since the turning point and of the force there. Equations: docs/nonlinear.md.

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

/// A Bouc–Wen force upwards from a turning point. It falls to zero with dz/du = 1 + (β − γ) |z|ⁿ and grows beyond with
/// 1 − (β + γ + 2φ) zⁿ, u in units of F/k.
class BoucWenBranch {
 public:
  BoucWenBranch(const BoucWen& law, double start);

  /// @param travel  ≥ 0
  [[nodiscard]] ForceOnTravel at(double travel) const;
  /// The travel at which the force changes its sign, if it does.
  [[nodiscard]] std::optional<double> to_zero() const;

 private:
  /// Of |z| on the way to zero, if γ > β: such a loop feeds energy.
  [[nodiscard]] double limit_against() const;

  std::shared_ptr<const Saturation> grows_;
  double stiffness_, force_, exponent_;
  double against_;  ///< β − γ
  double limit_;    ///< of z
  double from_;     ///< z at the start
  double rate_at_start_;
  double offset_;  ///< travel from z = 0 to the start
};

/// Limit of z upwards.
[[nodiscard]] double z_limit(const BoucWen& law);
[[nodiscard]] BoucWen mirrored(BoucWen law);

/// The force from one turning point to the next.
class HystereticBranch {
 public:
  /// @param start      the force at the turning point
  /// @param direction  of the travel, by its sign; upwards if it is 0
  HystereticBranch(const HystereticForce& law, double start, double direction);

  /// @param travel  in the direction of the branch; against it, where round-off puts a turning point, counts as none
  [[nodiscard]] ForceOnTravel at(double travel) const;
  /// The travel at which the force is not smooth: a slider begins to slip, a Bouc–Wen force changes its sign. Empty if
  /// there is none.
  [[nodiscard]] std::optional<double> kink() const;

 private:
  double sign_, start_;  ///< the force upwards is `sign_` times itself
  std::variant<Slider, BergFriction, BoucWenBranch, CoulombFriction> upwards_;
};

}  // namespace trivet::elements
