// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "trivet/elements/coil_spring.h"
#include "trivet/elements/helical_rod.h"

namespace trivet::elements {

using Matrix12c = Eigen::Matrix<std::complex<double>, 12, 12>;

/// A coil spring prepared for many frequencies: its rod, and the connection of each wire end to its seat.
struct SeatedCoil {
  HelicalRod rod;
  Matrix6 wire_from_seat_n, wire_from_seat_k;  ///< displacement of the wire's end, section axes, from that of the seat
  Matrix6 second_order_n, second_order_k;      ///< geometric stiffness of the lever from seat to wire end, by preload
  Matrix6 dead_mass_n, dead_mass_k;            ///< of the dead coils, at the seat
  Seat seat_n = Seat::clamped, seat_k = Seat::clamped;
  double loss_factor = 0;
};
/// @throws InvalidInput if the spring has errors or no density
[[nodiscard]] SeatedCoil seated_coil(const CoilSpring& spring);

/// Exact dynamic stiffness 12×12 at the seats, without loss factor. ω [rad/s] ≥ 0.
/// @throws NotComputable exactly at a natural frequency of the spring with both seats held
[[nodiscard]] Matrix12 dynamic_stiffness(const SeatedCoil& coil, double angular_frequency);
/// The same with loss factor, E(1 + iη) and G(1 + iη), continued to complex ω with Re ω ≥ 0.
[[nodiscard]] Matrix12c dynamic_stiffness(const SeatedCoil& coil, std::complex<double> angular_frequency);

[[nodiscard]] Matrix12 dynamic_stiffness(const CoilSpring& spring, double angular_frequency);
[[nodiscard]] Matrix12c dynamic_stiffness(const CoilSpring& spring, std::complex<double> angular_frequency);

/// Constraints of the seats while the spring itself vibrates. `lateral_slide`: K may move along e1 and e2 only.
enum class SeatsHeld { both, n_only, lateral_slide };

/// Number of natural frequencies below ω, by the Wittrick–Williams count; at ω = 0 the number of buckled modes of a
/// preloaded spring.
[[nodiscard]] int modes_below(const SeatedCoil& coil, double angular_frequency, SeatsHeld held = SeatsHeld::both);

/// The lowest `count` natural frequencies [rad/s] of the spring itself without loss factor, ascending, multiple ones
/// repeated: bisection on the count, so none is missed.
[[nodiscard]] std::vector<double> natural_frequencies(const SeatedCoil& coil, SeatsHeld held, int count);
[[nodiscard]] std::vector<double> natural_frequencies(const CoilSpring& spring, SeatsHeld held, int count);

}  // namespace trivet::elements
