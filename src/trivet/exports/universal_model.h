// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "trivet/exchange/universal/universal_file.h"
#include "trivet/exports/content.h"

namespace trivet::exports {

/// A node of a universal file, and the results that belong to it.
struct UniversalPlace {
  int label = 0;
  std::string name;                                    ///< BODY, BODY.POINT, ELEMENT.foot or ELEMENT.head
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< of its results, as columns in the ground frame
};

/// Nodes at the poles of bodies, their points and the ends of elements, and lines between them.
struct UniversalGeometry {
  std::vector<UniversalPlace> places;
  std::vector<exchange::UniversalNode> nodes;
  std::vector<exchange::UniversalLine> lines;

  /// Label of a place, 0 if there is none of this name.
  [[nodiscard]] int label(const std::string& name) const;
};
[[nodiscard]] UniversalGeometry universal_geometry(const model::System& system);

/// Node and direction ±1 … ±6 of a result such as "machine.seat.rz", or of a force or moment (direction 4 to 6) of an
/// element on its foot; node 0 for a result of no place, or an axis that is not one of the ground.
[[nodiscard]] exchange::UniversalPoint universal_point(const UniversalGeometry& geometry, const std::string& result);

/// Motion of every node in each undamped mode, six numbers per node.
[[nodiscard]] std::vector<exchange::UniversalMode> universal_modes(const model::System& system,
                                                                   const UniversalGeometry& geometry,
                                                                   const modal::Modes& modes);

}  // namespace trivet::exports
