// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/foundation/problems.h"
#include "trivet/study/map/design_map.h"

namespace trivet::study {

/// Do all designs around a mark of this model contradict it (all feasible and it is not, or the reverse)? Then the map
/// is too coarse there.
[[nodiscard]] bool contradicts(const DesignMap& map, const MapMark& mark);

/// Warnings about a map: unphysical bodies, marks that contradict the designs around them, resonances missed between
/// designs, ranges far from the model itself, answers that are zero, axes without effect, limits that no design can
/// meet at ω = 0.
/// @param variant  case of the model
[[nodiscard]] foundation::Problems map_warnings(const project::Case& variant, const DesignMap& map);

}  // namespace trivet::study
