// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "trivet/assembly/channels.h"

namespace trivet::response {

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
