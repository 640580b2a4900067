// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "trivet/modal/roots.h"
#include "trivet/response/machinery/order_loading.h"
#include "trivet/response/steady/frequency_grid.h"

namespace trivet::response {

/// One natural frequency, a horizontal line of the diagram: the model does not depend on the shaft speed.
struct NaturalLine {
  double angular_frequency = 0;  ///< Im λ of the damped root [rad/s]
  double damping_ratio = 0;
  std::optional<int> nearest_mode;  ///< see modal::Root
};

/// Intersection of an order line with a natural frequency within the speed range: Ω = Im λ / order.
struct Interference {
  std::size_t line = 0;  ///< index in Campbell::natural
  double order = 0;
  double speed = 0;              ///< Ω [rad/s]
  double angular_frequency = 0;  ///< [rad/s]
  std::optional<int> mode;       ///< mode of the natural line
  /// Modal force share |φᵀF|² / Σ |φ_iᵀF|² of that mode with the force F of the order at this speed: 0 … 1, sum over
  /// all modes 1. With φᵀAφ = 1 it is the share of the kinetic energy that a short impulse F gives the mode. Empty
  /// without a mode, or if the order excites no mode.
  std::optional<double> modal_force_share;
  bool excited = false;  ///< modal_force_share ≥ `excited_from`
};

/// Modes with a smaller modal force share (a thousandth of the amplitude) count as not excited.
inline constexpr double excited_from = 1e-6;

/// Campbell diagram of a system without gyroscopic terms.
struct Campbell {
  assembly::Band speed;  ///< [rad/s]
  std::vector<double> orders;
  std::vector<NaturalLine> natural;  ///< ascending
  std::vector<Interference> points;  ///< ascending speed
};

/// @throws foundation::InvalidInput unless 0 ≤ from < to
[[nodiscard]] Campbell campbell(const std::vector<OrderLoading>& order_loadings, const modal::Modes& modes,
                                const modal::Roots& roots, const assembly::Band& speed);

}  // namespace trivet::response
