// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/model/system.h"

namespace trivet::nonlinear {

/// Names of deflections in which friction, smooth loops or bristles alone hold a body: sliding parts have any mean, so
/// that the mean of a motion in which they slide is not determined. Empty if elastic parts, however far away, hold all
/// bodies, or if nothing does.
[[nodiscard]] std::vector<std::string> held_by_friction_alone(const model::System& system);

/// @param subject  of the message
/// @throws foundation::NotComputable if there are any
void require_elastic_hold(const model::System& system, const std::string& subject);

}  // namespace trivet::nonlinear
