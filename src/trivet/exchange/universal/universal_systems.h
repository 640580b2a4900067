// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/exchange/universal/universal_file.h"
#include "trivet/exchange/universal/universal_sets.h"

/// Coordinate systems of a universal file.
namespace trivet::exchange {

enum class UniversalSystemType : int { cartesian = 0, cylindrical = 1, spherical = 2 };

struct UniversalSystem {
  int label = 0;
  UniversalSystemType type = UniversalSystemType::cartesian;
  int reference = 0;                                   ///< system in which it is given; 0: global
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< its axes as columns, in the reference
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();    ///< [m] in the reference
};

/// Reads set 18: systems by origin, a point on +x and a point in the +xz plane. Systems defined in another way, or
/// without three different points, are left out with a warning; so is what follows a wrong line.
[[nodiscard]] std::vector<UniversalSystem> read_universal_systems(const UniversalSet& set, const UniversalUnits& units,
                                                                  SetProblems& problems);

/// Reads set 2420: systems by a matrix, the first three rows of which are the axes and the fourth is the origin.
[[nodiscard]] std::vector<UniversalSystem> read_universal_part_systems(const UniversalSet& set,
                                                                       const UniversalUnits& units,
                                                                       SetProblems& problems);

/// Applies the systems to the nodes: positions become global, and each node gets its axes of displacement. Nodes in
/// systems that are not known, or whose position is in a system that is not Cartesian, are marked.
void apply_systems(const std::vector<UniversalSystem>& systems, std::vector<UniversalNode>& nodes);

}  // namespace trivet::exchange
