// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/assembly/loads.h"
#include "trivet/numerics/sweep/frequency_sweep.h"

namespace trivet::response {

/// Coordinates at the given real ω ≥ 0 [rad/s], one column each, with the exact laws of frequency-dependent elements
/// (then only the first rows of the layout); NaN if Z(ω) is singular.
[[nodiscard]] numerics::SweepResult steady_solution(const assembly::Assembled& assembled,
                                                    const assembly::Loading& loading,
                                                    const std::vector<double>& angular_frequency,
                                                    const numerics::SweepOptions& options = {});

}  // namespace trivet::response
