// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "trivet/study/design_map.h"

namespace trivet::report {

/// The part of a map with one governing rule, or without an answer (see DesignOutcome), as closed outlines.
struct MapRegion {
  static constexpr std::uint8_t unlimited = study::DesignOutcome::not_computed - 1;
  std::uint8_t governing = 0;           ///< `unlimited` where no rule has a limit: nothing moves or peaks
  std::size_t designs = 0;              ///< of the grid
  std::vector<study::MapLine> rings;    ///< pieces side by side
};

/// All regions, the largest first. Borders lie half-way between designs, corners cut; of the drawn designs.
[[nodiscard]] std::vector<MapRegion> map_regions(const study::DesignMap& map);

}  // namespace trivet::report
