// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "trivet/foundation/problems.h"

namespace trivet::excitation {

// Excitation of machines: time histories, spectra, engines, weightings. This module does not read files or solve
// systems.

/// u on one piece, time from its start: u‴ = −κ²u′, so κ = 0 is a parabola and κ > 0 a sine plus a constant.
struct Piece {
  double start = 0;                           ///< [s]
  double value = 0, rate = 0, curvature = 0;  ///< u, u̇, ü at its start [unit, unit/s, unit/s²]
  double kappa = 0;                           ///< κ ≥ 0 [rad/s]
};

/// A time history of exact pieces: zero before the first, each piece up to the start of the next, the last one without
/// end. It may jump.
struct Signal {
  std::vector<Piece> pieces;  ///< starts increase
};

/// u, u̇, ü at one time.
struct SignalState {
  double value = 0, rate = 0, curvature = 0;
};

/// State on a sine, κ > 0, at time s after its start.
[[nodiscard]] SignalState state_on_sine(const Piece& piece, double s);

/// State at time s after the start of a piece, regardless of its neighbours.
[[nodiscard]] inline SignalState state_on(const Piece& p, double s) {
  if (p.kappa != 0) return state_on_sine(p, s);
  return {p.value + s * (p.rate + s / 2 * p.curvature), p.rate + s * p.curvature, p.curvature};
}

/// State at time t [s]; at a jump the one after it. Zero if the signal has no piece at t.
[[nodiscard]] SignalState state(const Signal& signal, double t);

/// Index of the piece at time t, or −1 before the first.
[[nodiscard]] std::ptrdiff_t piece_at(const Signal& signal, double t);

/// ∫u and ∬u from before the first piece up to t, in closed form: for an acceleration pulse the net change of velocity
/// and the displacement.
struct SignalIntegrals {
  double once = 0;   ///< [unit s]
  double twice = 0;  ///< [unit s²]
};
[[nodiscard]] SignalIntegrals integrals(const Signal& signal, double t);

/// The same on one piece alone, from its start to time s after it.
[[nodiscard]] SignalIntegrals integrals_on(const Piece& piece, double s);

/// u(t − τ), any τ [s].
[[nodiscard]] Signal delayed(Signal signal, double delay);

/// factor · u(t).
[[nodiscard]] Signal scaled(Signal signal, double factor);

/// @throws foundation::InvalidInput unless all numbers are finite, starts increase and κ ≥ 0
void require_valid(const Signal& signal);

/// A measured time history: values at increasing times [s], linear between them, zero before the first.
struct Samples {
  enum class Afterwards { hold, zero };
  std::vector<double> times;
  std::vector<double> values;
  Afterwards afterwards = Afterwards::hold;  ///< what follows the last sample
};

/// Errors: unequal counts, fewer than two, numbers not finite, times that do not increase. Warnings: a first value that
/// is not 0 (the signal jumps), a last one that is not 0 (it is held, or falls to zero with a jump).
[[nodiscard]] foundation::Problems check(const Samples& samples, const std::string& subject);

/// @throws foundation::InvalidInput with the first error of `check`
[[nodiscard]] Signal from_samples(const Samples& samples);

}  // namespace trivet::excitation
