// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "trivet/report/map/map_picture.h"
#include "trivet/report/map/map_regions.h"

namespace trivet::report {

inline constexpr std::size_t different_rules = 7;         ///< with a colour of their own; others are grey
inline constexpr const char* other_colour = "#d8d8d8";    ///< of these
inline constexpr const char* unknown_colour = "#8f8f8f";  ///< of designs that were not computed

/// Colour of the rule that governs most designs (rank 0), of the second …; neighbours differ in lightness too.
[[nodiscard]] const char* rule_colour(std::size_t rank);

/// Infeasible designs in full colour, feasible ones lighter and clipped at the boundary: it is exact, while the colours
/// are those of the nearest design on the same side.
/// @param name  of this picture, unique on its page  @param colour  of a region and its place in the list
void draw_regions(MapPicture& picture, const std::vector<MapRegion>& regions, const std::string& name,
                  const std::function<const char*(const MapRegion&, std::size_t)>& colour);

}  // namespace trivet::report
