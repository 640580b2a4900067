// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

#include "trivet/excitation/engine.h"
#include "trivet/excitation/slider_crank.h"

namespace trivet::excitation {

/// Permissible residual unbalance m e [kg m] of a rigid rotor: e ω = G. [ISO 21940-11]
/// @param grade_mm_per_s   balance quality grade G > 0, "G 6.3" is 6.3 [mm/s]
/// @param mass             of the rotor [kg] > 0
/// @param angular_speed    highest service speed [rad/s] > 0; m e is the same at lower speeds
/// @throws foundation::InvalidInput for numbers out of range
[[nodiscard]] double permissible_unbalance(double grade_mm_per_s, double mass, double angular_speed);

using ComplexVector6 = Eigen::Matrix<std::complex<double>, 6, 1>;

/// Excitation by a machine that turns at Ω, at one multiple of Ω: force and moment about the origin of its axes,
/// Re((Ω² per_speed_squared + fixed) e^{i order Ω t}).
struct Order {
  double order = 0;                                           ///< > 0
  ComplexVector6 per_speed_squared = ComplexVector6::Zero();  ///< [N/(rad/s)²], [N m/(rad/s)²]
  ComplexVector6 fixed = ComplexVector6::Zero();              ///< [N], [N m]
};

/// Forces and moments of the oscillating and rotating masses on the engine block, orders 1 … `highest`, and the
/// reaction moment about x to the inertia torque; θ = Ωt. The rod is modelled as two masses (its inertia couple is
/// neglected), Ω as constant. Entries that cancel between the cylinders to round-off are exactly 0, and orders without
/// entries are omitted.
/// @throws foundation::InvalidInput with the first error of `check`
[[nodiscard]] std::vector<Order> inertia_orders(const Engine& engine, int highest);

/// Reaction moment about x of the block to the gas torque of all cylinders, each with its firing angle. Order 0 is
/// omitted: it is the static moment −mean_torque.
/// @throws foundation::InvalidInput with the first error of `check`, for an unset firing angle, for orders that are
/// negative, not finite, repeated or not a harmonic of the cycle
[[nodiscard]] std::vector<Order> gas_orders(const Engine& engine, const std::vector<TorqueHarmonic>& one_cylinder);

/// Mean torque of all cylinders on the crank [N m].
[[nodiscard]] double mean_torque(const Engine& engine, const std::vector<TorqueHarmonic>& one_cylinder);

/// Both lists merged, ascending, equal orders added.
[[nodiscard]] std::vector<Order> joined(const std::vector<Order>& one, const std::vector<Order>& other);

}  // namespace trivet::excitation
