// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/assembly/channels.h"

namespace trivet::response {

/// Coordinates at rest under gravity and the constant forces: K q = Q (real part of K).
struct StaticSolution {
  Eigen::VectorXd coordinates;
  double backward_error = 0;
};

/// @throws foundation::NotComputable as `static_response`
[[nodiscard]] StaticSolution static_solution(const model::System& system, const assembly::Assembled& assembled);

/// Value of a displacement or force at rest.
[[nodiscard]] double value_at_rest(const assembly::Channel& channel, const assembly::Assembled& assembled,
                                   const StaticSolution& rest);

}  // namespace trivet::response
