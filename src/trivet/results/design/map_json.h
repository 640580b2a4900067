// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "trivet/study/map/design_map.h"

namespace trivet::results {

/// Receives a text piece by piece, so that the text of a million designs is never in memory as a whole.
using TextSink = std::function<void(std::string_view)>;

/// The whole map; contract in docs/map.md. @param warnings  of the model and of the map
void write_map_json(const study::DesignMap& map, const foundation::Problems& warnings, const TextSink& sink);

/// One row per design of the grid: both numbers, margin, governing rule, kept.
void write_map_csv(const study::DesignMap& map, const TextSink& sink);

/// The same as one text.
[[nodiscard]] std::string map_csv(const study::DesignMap& map);

/// The maps of several pairs: {"pairs": […], "warnings": […]}.
void write_map_pairs_json(const std::vector<study::DesignMap>& maps, const foundation::Problems& warnings,
                          const TextSink& sink);

/// One row per design, with the names of both parameters.
void write_map_pairs_csv(const std::vector<study::DesignMap>& maps, const TextSink& sink);
[[nodiscard]] std::string map_pairs_csv(const std::vector<study::DesignMap>& maps);

}  // namespace trivet::results
