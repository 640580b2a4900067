// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/assembly/channels.h"

namespace trivet::response {

/// Displacements at rest, q = q_w + q_l. The file shows the machine in balance with its weight, preloads and offsets
/// Q_w, whose deflection is K₀ q_w = Q_w. All other loads meet a machine whose forces at rest take part: K q_l = Q − K₀
/// q_w. K₀, K: real parts of the stiffness of the first order and with the second-order effect of the forces at rest.
struct StaticSolution {
  Eigen::VectorXd by_weight;  ///< q_w; everything if there is no such effect
  Eigen::VectorXd by_loads;   ///< q_l
  double backward_error = 0;

  [[nodiscard]] Eigen::VectorXd coordinates() const { return by_weight + by_loads; }
};

/// @throws foundation::NotComputable as `static_response`
[[nodiscard]] StaticSolution static_solution(const model::System& system, const assembly::Assembled& assembled);

/// What a motion q contributes to a displacement or force at rest; without `Channel::at_rest`.
/// @param assembled  of which the channel is
[[nodiscard]] double value_at_rest(const assembly::Channel& channel, const assembly::Assembled& assembled,
                                   const Eigen::VectorXd& motion);

}  // namespace trivet::response
