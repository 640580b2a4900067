// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/excitation/signal.h"

namespace trivet::excitation {

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
