// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/foundation/problems.h"
#include "trivet/project/measured/ground_mobility.h"

namespace trivet::project {

/// Problems of a mobility, and how far each driving point is from causality: rows that feed energy (Re Y must be
/// positive semidefinite), points that move as one rigid part (Y⁻¹ does not exist), driving points that no passive,
/// causal ground has, rows too far apart.
[[nodiscard]] foundation::Problems judge_mobility(GroundMobility& mobility);

}  // namespace trivet::project
