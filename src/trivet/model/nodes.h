// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/model/system.h"

namespace trivet::model {

/// Leaves out the directions of nodes, and the rotations of point masses, that no element holds, and checks that
/// elements hold every other one: docs/decisions/nodes-without-mass.md.
void settle_nodes(Description& description, foundation::Problems& problems);

/// "node joint: rotation about z is held by no element and left out", for every node with such directions.
[[nodiscard]] std::vector<std::string> left_out_notes(const Description& description);

}  // namespace trivet::model
