// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/excitation/signal.h"

/// Common steps and pulses. `amplitude` is the peak value, of any unit and sign, times are in s. All throw
/// foundation::InvalidInput for numbers that are not finite, and for durations that are not > 0.
namespace trivet::excitation {

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

}  // namespace trivet::excitation
