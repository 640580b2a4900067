// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "trivet/elements/rubber_layer.h"

namespace trivet::elements {

/// One element of a chain: its stress-free 12×12 and the vector from its N to its K [m].
struct SeriesPart {
  Matrix12 stiffness = Matrix12::Zero();
  Eigen::Vector3d arm = Eigen::Vector3d::Zero();
};

/// The 12×12 of parts in series, K of each rigidly attached to N of the next, from N of the first to K of the last:
/// exact static condensation, by adding their flexibilities at the last end. Massless joints. A rigid spacer is an arm
/// between two parts: `spacers[i]` is the vector from K of part i to N of part i + 1, one fewer than the parts. arm =
/// sum of all arms and spacers.
/// @throws InvalidInput if there is no part, the counts do not match, or a part is free to move
[[nodiscard]] Matrix12 in_series(const std::vector<SeriesPart>& parts, const std::vector<Eigen::Vector3d>& spacers);

/// Equal rubber layers, rigid plates between them. N and K are the centres of the outer bonded faces, e3 from N to K:
/// arm = (0, 0, layers · thickness + (layers − 1) · plate_thickness).
struct Sandwich {
  std::variant<RubberDisc, RubberBlock> layer;
  int layers = 0;
  double plate_thickness = 0;  ///< of each inner plate [m], ≥ 0
};

[[nodiscard]] double height(const Sandwich& sandwich);
/// @throws InvalidInput if check() finds an error
[[nodiscard]] Matrix12 sandwich(const Sandwich& sandwich);
[[nodiscard]] foundation::Problems check(const Sandwich& sandwich);

}  // namespace trivet::elements
