// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/design_map.h"

namespace trivet::study {

/// The whole map; contract in docs/map.md.
[[nodiscard]] std::string map_json(const Project& project, const DesignMap& map);

/// One row per design of the grid: both numbers, margin, governing rule, kept.
[[nodiscard]] std::string map_csv(const DesignMap& map);

}  // namespace trivet::study
