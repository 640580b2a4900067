// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/elements/hysteresis.h"
#include "trivet/identification/hysteresis_loop.h"

namespace trivet::identification {

/// A spring k δ + a δ² + c δ³ beside a Bouc–Wen force with β = γ = ½: slow loops of wire ropes and other dry friction.
struct RopeFit {
  double stiffness = 0;        ///< k, of large loops [N/m]
  double quadratic = 0;        ///< a [N/m²]
  double cubic = 0;            ///< c [N/m³]
  elements::BoucWen friction;  ///< its stiffness adds to k in small loops
  std::vector<double> rms;     ///< of each loop: deviation of the force's harmonics over that of its first
  double relative_rms = 0;     ///< of all
};

/// Least squares over the harmonics of all loops, each divided by the first harmonic of its force. Problems: fewer than
/// two loops, amplitudes that hardly differ, no friction in the loops.
[[nodiscard]] foundation::Expected<RopeFit> rope_fit(const std::vector<LoopFit>& loops);

}  // namespace trivet::identification
