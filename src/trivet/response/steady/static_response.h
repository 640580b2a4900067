// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/assembly/channels.h"

namespace trivet::response {

/// One static result, SI.
struct StaticValue {
  std::string name;
  std::string unit;
  double value = 0;
};

/// A static result as a linear function of the displacements at rest: row · q + at_rest.
struct RestRow {
  Eigen::RowVectorXd row;
  double at_rest = 0;
};
[[nodiscard]] RestRow rest_row(const assembly::Assembled& assembled, const assembly::Channel& channel);

struct StaticResponse {
  std::vector<StaticValue> values;
  double backward_error = 0;
};

/// Static displacements, point motions and forces under gravity and the constant forces: K q = Q (real part of K).
/// @throws foundation::NotComputable if the system has rigid-body modes (the message names them) or no static load
[[nodiscard]] StaticResponse static_response(const model::System& system, const assembly::Assembled& assembled,
                                             const std::vector<assembly::Channel>& channels);

}  // namespace trivet::response
