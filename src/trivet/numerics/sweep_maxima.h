// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/designs.h"
#include "trivet/numerics/frequency_sweep.h"

namespace trivet::numerics {

/// The largest |q_j| over a list of frequencies, one row per design, without keeping the others.
struct SweepMaxima : SweepCounts {
  Eigen::ArrayXXd amplitude;           ///< designs × n; infinite where Z(ω) is singular
  Eigen::ArrayXXd angular_frequency;   ///< [rad/s] where it is, the lowest of equals
};

/// Of one system.
[[nodiscard]] SweepMaxima sweep_maxima(const DynamicMatrices& matrices, const Load& load, const std::vector<double>& omega,
                                       const SweepOptions& options = {});

/// Of many: the frequencies of one design after the other through the kernels of `sweep`, designs in pieces on threads.
[[nodiscard]] SweepMaxima sweep_maxima(const Designs& designs, const std::vector<double>& omega, const SweepOptions& options = {});

}  // namespace trivet::numerics
