// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "trivet/exchange/universal/universal_file.h"
#include "trivet/foundation/problems.h"

namespace trivet::project {

/// Nodes with functions (response or reference) or mode shapes whose position or whose directions are in a coordinate
/// system that the file does not define.
[[nodiscard]] std::vector<exchange::UniversalNode> nodes_in_systems(const exchange::UniversalFile& file);

/// A point with its direction along an axis of the ground; none if the axis of its node is not along one.
[[nodiscard]] std::optional<exchange::UniversalPoint> in_ground(const exchange::UniversalPoint& point,
                                                                const std::vector<exchange::UniversalNode>& nodes);

/// Turns mode shapes from the axes of their nodes to those of the ground.
void turn_to_ground(const std::vector<exchange::UniversalNode>& nodes, std::vector<exchange::UniversalMode>& modes);

/// Warns of those whose directions are in such a system: they are read as axes of the ground.
[[nodiscard]] foundation::Problems judge_directions(const std::vector<exchange::UniversalNode>& nodes);

/// Warns that nodes in coordinate systems have no place by their position.
[[nodiscard]] foundation::Problems judge_positions(const std::vector<exchange::UniversalNode>& nodes);

}  // namespace trivet::project
