// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/map/design_map.h"

namespace trivet::results {

/// A map as text: the feasible share, the governing rules, the best design and every marked case.
[[nodiscard]] std::string map_text(const study::DesignMap& map);

/// One after another, and what holds for all of them once.
[[nodiscard]] std::string map_pairs_text(const std::vector<study::DesignMap>& maps);

}  // namespace trivet::results
