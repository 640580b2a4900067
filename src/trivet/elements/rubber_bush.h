// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/elements/law.h"
#include "trivet/elements/materials.h"
#include "trivet/foundation/problems.h"

namespace trivet::elements {

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
