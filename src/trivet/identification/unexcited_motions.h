// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace trivet::identification {

/// Descriptions of the motions that no column of `motions` contains: "no load case tilts K about y", or for a
/// combination "every load case has u_K x + 0.1 θ_K y = 0". 6 rows are the motion of K relative to N, 12 rows both
/// ends. [m, rad]
[[nodiscard]] std::vector<std::string> unexcited_motions(const Eigen::MatrixXd& motions);

}  // namespace trivet::identification
