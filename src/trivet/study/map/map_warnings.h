// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/design/design_outcome.h"
#include "trivet/foundation/problems.h"
#include "trivet/project/project.h"
#include "trivet/study/map/design_map.h"

namespace trivet::study {

/// Effect of the two numbers of a map on the channels of its rules, from 3 × 3 designs at three frequencies each.
struct AxisEffects {
  std::vector<std::string> zero_channels;  ///< channels that are zero except for round-off in all of them
  bool by_x = true, by_y = true;           ///< false: no channel changes its amplitude along this axis
};

/// Reports no findings if one of these designs has no model or no result.
[[nodiscard]] AxisEffects axis_effects(const project::Case& variant, const project::MapRequest& request,
                                       const std::vector<design::MapRule>& rules);

/// Do all designs around a mark of this model contradict it (all feasible and it is not, or the reverse)? Then the map
/// is too coarse there.
[[nodiscard]] bool contradicts(const DesignMap& map, const MapMark& mark);

/// Warnings about a map: unphysical bodies, marks that contradict the designs around them, resonances missed between
/// designs, ranges far from the model itself, channels that are zero, axes without effect, limits that no design can
/// meet at ω = 0.
/// @param variant  case of the model
[[nodiscard]] foundation::Problems map_warnings(const project::Case& variant, const DesignMap& map);

}  // namespace trivet::study
