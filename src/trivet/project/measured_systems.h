// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/exchange/universal_file.h"
#include "trivet/foundation/problems.h"

namespace trivet::project {

/// Nodes with functions (response or reference) or mode shapes whose position or whose directions are in a coordinate
/// system of the file.
[[nodiscard]] std::vector<exchange::UniversalNode> nodes_in_systems(const exchange::UniversalFile& file);

/// Warns of those whose directions are in a coordinate system: they are read as axes of the ground.
[[nodiscard]] foundation::Problems judge_directions(const std::vector<exchange::UniversalNode>& nodes);

/// Warns that nodes in coordinate systems have no place by their position.
[[nodiscard]] foundation::Problems judge_positions(const std::vector<exchange::UniversalNode>& nodes);

}  // namespace trivet::project
