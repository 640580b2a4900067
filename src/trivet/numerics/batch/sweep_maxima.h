// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/roots/designs.h"
#include "trivet/numerics/sweep/frequency_sweep.h"

namespace trivet::numerics {

/// Largest |q_j| over a list of frequencies, one row per design; the other values are not stored.
struct SweepMaxima : SweepCounts {
  Eigen::ArrayXXd amplitude;          ///< designs × n; infinite if Z(ω) is singular
  Eigen::ArrayXXd angular_frequency;  ///< [rad/s] at which it occurs, the lowest if several are equal
};

/// Largest amplitudes of one system.
[[nodiscard]] SweepMaxima sweep_maxima(const DynamicMatrices& matrices, const Load& load,
                                       const std::vector<double>& omega, const SweepOptions& options = {});

/// Largest amplitudes of many designs, in pieces on threads. If no backward errors are requested, they come from the
/// poles of eight designs at once, provided these pass the checks of design_peaks.h (up to twelve coordinates, at least
/// 32 frequencies): accurate to nine digits, near a resonance to ε/ζ like a direct solution; a coordinate that the load
/// moves by round-off only is then 0. Otherwise one design after the other is solved at all frequencies by the kernels
/// of `sweep`.
[[nodiscard]] SweepMaxima sweep_maxima(const Designs& designs, const std::vector<double>& omega,
                                       const SweepOptions& options = {});

}  // namespace trivet::numerics
