// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/model/system.h"

namespace trivet::model {

/// The constrained coordinates of a body along which the whole ground moves, "y, rz"; empty if there are none. The
/// constraints are fixed in space, so the ground moves away under the body.
/// @param motion  of the ground about `at`, ground axes
[[nodiscard]] std::string coordinates_left_behind(const Body& body, const Action::Amplitude& motion,
                                                  const Eigen::Vector3d& at);

/// Adds one warning that the constraints are fixed in space.
void warn_of_guides(const Body& body, const std::string& coordinates, const std::string& cause,
                    foundation::Problems& problems);

}  // namespace trivet::model
