// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

#include "trivet/numerics/roots/designs.h"

namespace trivet::study {

/// |y| of all curves of one design at many frequencies, frequencies × curves; infinite at an undamped resonance. Solved
/// by the frequency sweep, one frequency per lane, with its checks (docs/decisions/no-pivoting-first.md).
/// @param omega  > 0 [rad/s]
[[nodiscard]] Eigen::ArrayXXd packed_amplitudes(const numerics::DrivenDesigns& designs, Eigen::Index design,
                                                const std::vector<double>& omega);

}  // namespace trivet::study
