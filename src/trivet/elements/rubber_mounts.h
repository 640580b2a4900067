// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "trivet/elements/law.h"
#include "trivet/elements/materials.h"
#include "trivet/elements/rubber_layer.h"
#include "trivet/foundation/problems.h"

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

/// Rubber sleeve bonded to a rigid outer tube (end N) and a rigid inner tube or pin (end K); both reference points are
/// its centre, e3 is its axis: arm = 0. Free flat ends. Lengths [m]. Formulas, range and measured accuracy:
/// docs/elements/rubber.md.
struct RubberBush {
  Rubber rubber;
  double inner_radius = 0;
  double outer_radius = 0;
  double length = 0;
  double dynamic_factor = 1;
};

/// Axial stiffness 2πGL/ln(ro/ri) [N/m]: long bush, free ends neglected.
[[nodiscard]] double long_bush_axial(const RubberBush& bush);
/// Torsional stiffness 4πGL/(1/ri² − 1/ro²) [N m/rad]: exact for any length.
[[nodiscard]] double bush_torsion(const RubberBush& bush);
/// Radial stiffness [N/m] of a slice in plane strain (very long bush) and in plane stress (very short); Adkins and Gent
/// 1954 if K is infinite.
[[nodiscard]] double long_bush_radial(const RubberBush& bush);
[[nodiscard]] double short_bush_radial(const RubberBush& bush);

/// Stiffnesses at the centre: [N/m] and, for tilting the pin about a transverse axis and turning it about e3, [N
/// m/rad].
struct BushConstants {
  double radial = 0, axial = 0, tilt = 0, torsion = 0;
};
[[nodiscard]] BushConstants bush_constants(const RubberBush& bush);

/// @throws InvalidInput if check() finds an error
[[nodiscard]] Matrix12 rubber_bush(const RubberBush& bush);
[[nodiscard]] foundation::Problems check(const RubberBush& bush);

}  // namespace trivet::elements
