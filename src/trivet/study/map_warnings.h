// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/foundation/problems.h"
#include "trivet/study/design_map.h"

namespace trivet::study {

/// Do all designs around a mark of this model agree with each other, and not with it? Then the map is too coarse there.
[[nodiscard]] bool contradicts(const DesignMap& map, const MapMark& mark);

/// What a reader must know before trusting a map: bodies that cannot be, marks that contradict the designs around them,
/// resonances that pass unseen between designs, ranges far from the model itself, answers that do not move, axes that
/// change nothing, limits that no design can keep at rest.
/// @param variant  whose model it is
[[nodiscard]] foundation::Problems map_warnings(const project::Case& variant, const DesignMap& map);

}  // namespace trivet::study
