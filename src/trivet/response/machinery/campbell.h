// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "trivet/modal/roots.h"
#include "trivet/response/machinery/order_loading.h"
#include "trivet/response/steady/frequency_grid.h"

namespace trivet::response {

/// A natural frequency: a level line, as nothing in the model changes with the shaft speed.
struct NaturalLine {
  double angular_frequency = 0;  ///< Im λ of the damped root [rad/s]
  double damping_ratio = 0;
  std::optional<int> nearest_mode;  ///< see modal::Root
};

/// Where an order meets a natural frequency within the speed range: Ω = Im λ / order.
struct Interference {
  std::size_t line = 0;  ///< of Campbell::natural
  double order = 0;
  double speed = 0;              ///< Ω [rad/s]
  double angular_frequency = 0;  ///< [rad/s]
  std::optional<int> mode;       ///< of the natural line
  /// |φᵀF|² / Σ |φ_iᵀF|² of that mode for the force F of the order at this speed: 0 … 1, and 1 over all modes. With
  /// φᵀAφ = 1 it is the share of the kinetic energy that a short push by F brings into the mode. None without mode, or
  /// if the order rests.
  std::optional<double> modal_force_share;
  bool excited = false;  ///< modal_force_share ≥ `excited_from`
};

/// Modal force shares below are called not excited: an amplitude of a thousandth.
inline constexpr double excited_from = 1e-6;

/// Campbell diagram of a system without gyroscopic terms.
struct Campbell {
  Band speed;  ///< [rad/s]
  std::vector<double> orders;
  std::vector<NaturalLine> natural;  ///< ascending
  std::vector<Interference> points;  ///< ascending speed
};

/// @throws foundation::InvalidInput for a band that is none
[[nodiscard]] Campbell campbell(const std::vector<OrderLoading>& order_loadings, const modal::Modes& modes,
                                const modal::Roots& roots, const Band& speed);

}  // namespace trivet::response
