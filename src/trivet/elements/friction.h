// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::elements {

// Friction of bristles, whose force depends on the course of a deflection and on its rate v.

/// The bristles deflect by z: dz/dt = v − σ_0 |v| z/g(v), f = σ_0 z + σ_1 dz/dt + σ_2 v, with the force of steady slip
/// g(v) = F_c + (F_s − F_c) e^{−(v/v_s)²}. [Canudas de Wit, Olsson, Åström, Lischinsky, IEEE Trans. Autom. Control 40
/// (1995)]
struct LuGreFriction {
  double stiffness = 0;          ///< σ_0 [N/m or N m/rad], > 0
  double slip = 0;               ///< F_c, of fast slip [N or N m], > 0
  double breakaway = 0;          ///< F_s, of slow slip; that of fast slip if it is smaller
  double stribeck_velocity = 0;  ///< v_s [m/s or rad/s], > 0 if F_s > F_c
  double damping = 0;            ///< σ_1 [N s/m or N m s/rad], ≥ 0
  double viscous = 0;            ///< σ_2 [N s/m or N m s/rad], ≥ 0

  [[nodiscard]] double limit() const { return breakaway > slip ? breakaway : slip; }
  [[nodiscard]] bool has_stribeck_effect() const { return breakaway > slip; }
};

/// p = σ_0 sgn v/g(v) [1/m or 1/rad] and dp/dv: dz/dt = v (1 − p z).
struct BristleDecay {
  double per_travel = 0, by_rate = 0;
};
/// @param sense  ±1: of the travel, also where it has no rate
[[nodiscard]] BristleDecay bristle_decay(const LuGreFriction& law, double rate, double sense);

/// Force of slow slip after the first deflection of all, F_s (1 − e^{−σ_0 |x|/F_s}) sgn x, and its tangent.
struct VirginBristles {
  double force = 0, tangent = 0;
};
[[nodiscard]] VirginBristles virgin_force(const LuGreFriction& law, double deflection);

/// Least σ_2 with which no motion feeds energy: σ_1 (F_s/F_c − 1). [Barabanov, Ortega, IEEE Trans. Autom. Control 45
/// (2000)]
[[nodiscard]] double least_passive_viscous(const LuGreFriction& law);

// Friction across a contact, whose limit follows the pressure on it.

/// A spring k across the contact, equal in all directions of its plane, which bears the force f by the travel u of the
/// bodies: f' = k u' while |f| < μ P (it sticks); where |f| = μ P it slips, and f' = k u' − λ f/|f| with λ ≥ 0 so that
/// |f| stays μ P. Without pressure there is no force.
struct RubbingFriction {
  double coefficient = 0;  ///< μ, > 0
  double stiffness = 0;    ///< k [N/m], > 0
};

/// The force after a short travel under slip, and its derivatives.
struct Slip {
  Eigen::Vector2d force = Eigen::Vector2d::Zero();
  Eigen::Matrix2d by_start = Eigen::Matrix2d::Zero(), by_travel = Eigen::Matrix2d::Zero();
  Eigen::Vector2d by_limit = Eigen::Vector2d::Zero(), by_limit_before = Eigen::Vector2d::Zero();
  Eigen::Vector2d by_hoop = Eigen::Vector2d::Zero();
};

/// Along a straight travel the force turns into its direction: with the angle φ between them, dφ/ds = −(k/L) sin φ, so
/// that tan φ/2 falls by e^{−k ∫ ds/L}, here with a limit L that changes evenly. Errors fall with the square of the
/// travel.
/// @param start         force before; without one it begins along the travel
/// @param limit_before  of the force before the travel
/// @param limit         after it
[[nodiscard]] Slip slip(double stiffness, const Eigen::Vector2d& start, const Eigen::Vector2d& travel,
                        double limit_before, double limit);

/// The same within a ring, where the friction around it is `hoop` times the force over the travel on its wall: the
/// forces over the travel before and after, of which the friction keeps the limit.
[[nodiscard]] Slip slip_on_wall(double stiffness, const Eigen::Vector2d& start, const Eigen::Vector2d& travel,
                                double limit_before, double limit, double hoop);

}  // namespace trivet::elements
