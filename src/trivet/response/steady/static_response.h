// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "trivet/assembly/channels.h"

namespace trivet::response {

/// Loads at rest by the stiffness that they meet. The file shows the machine in balance with its weight, preloads and
/// offsets, which have deflected it against K₀, of the first order. All other loads meet a machine whose forces at rest
/// take part in its stiffness K; so does everything if K₀ does not hold the machine, or a hung body is beside its plumb
/// line. Both stiffnesses are real parts.
struct RestLoads {
  Eigen::VectorXd on_first, on_whole;
};
[[nodiscard]] RestLoads rest_loads(const model::System& system, const assembly::Assembled& assembled);

/// Displacements at rest, q = q_w + q_l: K₀ q_w = on_first, K q_l = on_whole.
struct StaticSolution {
  Eigen::VectorXd by_weight;  ///< q_w
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

/// One static result, SI.
struct StaticValue {
  std::string name;
  std::string unit;
  double value = 0;
};

/// A static result as a linear function of the displacements by the weight and by other loads, see StaticSolution:
/// row · q_w + beside · q_l + at_rest.
struct RestRow {
  Eigen::RowVectorXd row, beside;
  double at_rest = 0;
};
[[nodiscard]] RestRow rest_row(const model::System& system, const assembly::Assembled& assembled,
                               const std::string& name);

struct StaticResponse {
  std::vector<StaticValue> values;
  double backward_error = 0;
};

/// Static displacements, point motions and forces under gravity and the constant forces (StaticSolution).
/// @param of  names as for `assembly::channels`
/// @throws foundation::NotComputable if the system has rigid-body modes (the message names them) or no static load
[[nodiscard]] StaticResponse static_response(const model::System& system, const assembly::Assembled& assembled,
                                             const std::vector<std::string>& of);

}  // namespace trivet::response
