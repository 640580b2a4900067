// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/model/system.h"

namespace trivet::model {

/// The coordinates in which the guides of a body hold it in space while the whole ground moves along them, "y, rz";
/// empty where the body follows or the ground does not move so.
/// @param motion  of the ground about `at`, ground axes
[[nodiscard]] std::string coordinates_left_behind(const Body& body, const Action::Amplitude& motion,
                                                  const Eigen::Vector3d& at);

/// One warning that guides stand still in space.
void warn_of_guides(const Body& body, const std::string& coordinates, const std::string& cause,
                    foundation::Problems& problems);

}  // namespace trivet::model
