// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "trivet/report/map/map_picture.h"
#include "trivet/results/design/map_colours.h"
#include "trivet/study/map/design_map.h"

namespace trivet::report {

/// The part of a map with one governing rule, or with designs that were not computed (see DesignOutcome), as closed
/// outlines.
struct MapRegion {
  static constexpr std::uint8_t unlimited = results::MapColours::unlimited;
  std::uint8_t governing = 0;  ///< `unlimited` if no rule limits the designs: no motion or no peak
  std::size_t designs = 0;     ///< of the grid
  std::vector<design::MapLine> infeasible,
      feasible;  ///< adjacent pieces on each side of the boundary; they extend beyond it

  [[nodiscard]] bool known() const { return governing <= unlimited; }
};

/// All regions of the drawn designs, the largest first, those not computed last. Borders are half-way between designs,
/// with corners cut. The pieces of each side of the boundary come only from designs on that side, so that no place gets
/// the rule of a design beyond: clip the feasible pieces by the outline of the feasible region.
[[nodiscard]] std::vector<MapRegion> map_regions(const study::DesignMap& map);

/// Infeasible designs in full colour, feasible ones lighter and clipped at the boundary: it is exact, while the colours
/// are those of the nearest design on the same side.
/// @param name  of this picture, unique on its page
void draw_regions(MapPicture& picture, const std::vector<MapRegion>& regions, const std::string& name,
                  const results::MapColours& colours);

}  // namespace trivet::report
