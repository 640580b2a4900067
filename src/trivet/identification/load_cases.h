// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <limits>
#include <string>
#include <vector>

#include "trivet/foundation/problems.h"
#include "trivet/spatial/types.h"

namespace trivet::identification {

using spatial::Matrix12;
using spatial::Matrix6;
using spatial::Vector12;
using spatial::Vector6;

/// One quasi-static measurement on a test rig: the imposed displacements of both ends and the wrenches, in the
/// element's local frame, order (u_N, θ_N, u_K, θ_K), [m, rad] and [N, N m]. The wrench is what the rig exerts on the
/// element at the end's reference point; NaN marks a channel that was not measured.
struct LoadCase {
  std::string name;
  Vector12 displacement = Vector12::Constant(std::numeric_limits<double>::quiet_NaN());
  Vector12 wrench = Vector12::Constant(std::numeric_limits<double>::quiet_NaN());
};

/// Load case of a rig that fixes N, moves K and measures there.
[[nodiscard]] LoadCase moved_end_case(std::string name, const Vector6& displacement, const Vector6& wrench);

/// "force x at K", "moment z at N": name of a channel of the wrench.
[[nodiscard]] std::string channel_words(int channel);

/// "u_K x", "θ_N z": name of a coordinate of the displacement.
[[nodiscard]] std::string coordinate_words(int coordinate);

/// Reasons why the cases cannot be used: no case, displacements that are not finite or all zero, infinite wrenches,
/// cases without a reading, two cases of one name (warning).
[[nodiscard]] foundation::Problems load_case_problems(const std::vector<LoadCase>& cases);

/// Descriptions of the motions that no column of `motions` contains: "no load case tilts K about y", or for a
/// combination "every load case has u_K x + 0.1 θ_K y = 0". 6 rows are the motion of K relative to N, 12 rows both
/// ends. [m, rad]
[[nodiscard]] std::vector<std::string> unexcited_motions(const Eigen::MatrixXd& motions);

}  // namespace trivet::identification
