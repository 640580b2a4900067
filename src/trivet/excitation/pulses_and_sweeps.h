// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/excitation/signal.h"

namespace trivet::excitation {

// Common steps and pulses. `amplitude` is the peak value, of any unit and sign, times are in s. All throw
// foundation::InvalidInput for numbers that are not finite, and for durations that are not > 0.

/// 0 before `at`, then `amplitude`.
[[nodiscard]] Signal step(double amplitude, double at = 0);

/// Rises linearly within `rise`, then constant.
[[nodiscard]] Signal ramp(double amplitude, double rise, double at = 0);

/// Rises as amplitude (1 − cos(πs/rise))/2, then constant: a step with continuous slope.
[[nodiscard]] Signal rounded_step(double amplitude, double rise, double at = 0);

[[nodiscard]] Signal rectangular(double amplitude, double duration, double start = 0);

/// amplitude sin(πs/duration).
[[nodiscard]] Signal half_sine(double amplitude, double duration, double start = 0);

/// amplitude (1 − cos(2πs/duration))/2, the haversine or versed sine, with continuous slope.
[[nodiscard]] Signal versed_sine(double amplitude, double duration, double start = 0);

/// Rises, holds and falls; each of the three times ≥ 0, their sum > 0.
[[nodiscard]] Signal trapezoid(double amplitude, double rise, double hold, double fall, double start = 0);

/// A triangle; fall = 0 is the terminal-peak sawtooth, rise = 0 the initial-peak one.
[[nodiscard]] Signal triangle(double amplitude, double rise, double fall, double start = 0);
[[nodiscard]] inline Signal terminal_peak_sawtooth(double amplitude, double duration, double start = 0) {
  return triangle(amplitude, duration, 0, start);
}

/// amplitude sin(ω s) for a number of cycles > 0, then zero (with a jump unless the cycles are whole or half). ω > 0
/// [rad/s].
[[nodiscard]] Signal sine_burst(double amplitude, double angular_frequency, double cycles, double start = 0);

/// A sine with a frequency that changes from one value to another: u = a(t) sin φ(t), φ̇ = ω(t), φ = `phase` at the
/// start; zero afterwards.
struct Sweep {
  enum class Law { linear, logarithmic };  ///< ω changes by equal amounts, or by equal ratios, in equal times
  enum class Amplitude {
    constant,
    speed_squared  ///< a(t) = amplitude (ω(t)/to)²: the run-up of an unbalance; the amplitude is reached at `to`
  };
  double amplitude = 0;
  double from = 0, to = 0;  ///< [rad/s]; > 0 (linear: ≥ 0), may fall; `speed_squared` refers to `to` > 0
  double duration = 0;      ///< [s] > 0
  Law law = Law::linear;
  Amplitude amplitude_law = Amplitude::constant;
  double phase = 0;  ///< [rad]
  double start = 0;  ///< [s]
};

/// Exact state of the sweep, for 0 ≤ s ≤ duration after its start.
[[nodiscard]] SignalState sweep_state(const Sweep& sweep, double s);

/// The sweep as parabolas with continuous value and rate: both are exact at every second joint; between them the value
/// has an error of at most `tolerance` of the local amplitude (the rate of about 4 tolerance^(2/3) of amplitude times
/// frequency). tolerance in [1e-12, 0.1]; 1e-5 takes about 85 parabolas per cycle.
/// @throws foundation::InvalidInput for numbers out of range, foundation::NotComputable above six million parabolas
[[nodiscard]] Signal sweep_signal(const Sweep& sweep, double tolerance = 1e-5);

}  // namespace trivet::excitation
