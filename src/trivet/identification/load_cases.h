// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// One quasi-static reading of a test rig: what both ends were made to do and what it took, in the element's local
/// frame, order (u_N, θ_N, u_K, θ_K), [m, rad] and [N, N m]. The wrench is what the rig exerts on the element at the
/// end's reference point; NaN marks a channel that was not measured.
struct LoadCase {
  std::string name;
  Vector12 displacement = Vector12::Constant(std::numeric_limits<double>::quiet_NaN());
  Vector12 wrench = Vector12::Constant(std::numeric_limits<double>::quiet_NaN());
};

/// A case of a rig that holds N fixed, moves K and measures there.
[[nodiscard]] LoadCase moved_end_case(std::string name, const Vector6& displacement, const Vector6& wrench);

/// "force x at K", "moment z at N": a channel of the wrench in words.
[[nodiscard]] std::string channel_words(int channel);

/// "u_K x", "θ_N z": a coordinate of the displacement.
[[nodiscard]] std::string coordinate_words(int coordinate);

/// Everything that keeps the cases from being used: no case, displacements that are not finite or all null, infinite
/// wrenches, cases without a reading, two cases of one name (warning).
[[nodiscard]] foundation::Problems load_case_problems(const std::vector<LoadCase>& cases);

}  // namespace trivet::identification
