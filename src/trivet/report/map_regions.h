// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "trivet/study/design_map.h"

namespace trivet::report {

/// The part of a map with one governing rule, or without an answer (see DesignOutcome), as closed outlines.
struct MapRegion {
  static constexpr std::uint8_t unlimited = design::DesignOutcome::not_computed - 1;
  std::uint8_t governing = 0;  ///< `unlimited` where no rule has a limit: nothing moves or peaks
  std::size_t designs = 0;     ///< of the grid
  std::vector<design::MapLine> broken,
      kept;  ///< pieces side by side, of each side of the boundary; they reach beyond it

  [[nodiscard]] bool known() const { return governing <= unlimited; }
};

/// All regions, the largest first, those without an answer last. Borders lie half-way between designs, corners cut; of
/// the drawn designs. Along the boundary each side is that of the designs on this side, so that a place never has the
/// rule of a design beyond: cut what is kept by the outline of the feasible region.
[[nodiscard]] std::vector<MapRegion> map_regions(const study::DesignMap& map);

}  // namespace trivet::report
