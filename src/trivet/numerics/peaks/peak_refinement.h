// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/numerics/peaks/disc_search.h"

namespace trivet::numerics {

/// A maximum after Newton steps on d|y|²/dω in extended precision.
struct RefinedPeak {
  double angular_frequency = 0;  ///< [rad/s]
  double amplitude = 0;
  double frequency_uncertainty = 0;  ///< [rad/s] by which one unit of round-off in A, B, K can move it (first order)
  double amplitude_uncertainty = 0;  ///< likewise its height
  bool converged = false;
};

/// Starts at `omega`; gives up (converged = false, values at the last step) if a step leaves [omega − reach, omega +
/// reach].
[[nodiscard]] RefinedPeak refine_peak(const DrivenSystem& system, const ObservedCurve& curve, double omega,
                                      double reach);

}  // namespace trivet::numerics
