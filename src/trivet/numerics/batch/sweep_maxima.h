// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/roots/designs.h"
#include "trivet/numerics/sweep/frequency_sweep.h"

namespace trivet::numerics {

/// The largest |q_j| over a list of frequencies, one row per design, without keeping the others.
struct SweepMaxima : SweepCounts {
  Eigen::ArrayXXd amplitude;          ///< designs × n; infinite where Z(ω) is singular
  Eigen::ArrayXXd angular_frequency;  ///< [rad/s] where it is, the lowest of equals
};

/// Of one system.
[[nodiscard]] SweepMaxima sweep_maxima(const DynamicMatrices& matrices, const Load& load,
                                       const std::vector<double>& omega, const SweepOptions& options = {});

/// Of many, in pieces on threads. Where no backward errors are asked for, by the poles of eight designs at once, if
/// these pass the checks of design_peaks.h (up to twelve coordinates, 32 frequencies at least): to nine digits, near a
/// resonance as far off as a direct solution may be, ε/ζ; a coordinate that the load moves by round-off only is 0 then.
/// Otherwise the frequencies of one design after the other through the kernels of `sweep`.
[[nodiscard]] SweepMaxima sweep_maxima(const Designs& designs, const std::vector<double>& omega,
                                       const SweepOptions& options = {});

}  // namespace trivet::numerics
