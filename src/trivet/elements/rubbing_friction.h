// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

/// Friction across a contact, whose limit follows the pressure on it.
namespace trivet::elements {

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
