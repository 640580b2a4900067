// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/report/drawing/figures.h"
#include "trivet/study/map/design_map.h"

namespace trivet::report {

/// Map with regions by governing rule, the feasible region lighter with its boundary and lines of equal margin, and
/// cases as labelled points.
[[nodiscard]] Figure map_figure(const study::DesignMap& map, const std::string& title);

/// Small maps of several pairs of parameters with the same rules: a column for each first parameter, a row for each
/// second one. Colours mean the same in all of them.
[[nodiscard]] Figure map_matrix_figure(const std::vector<study::DesignMap>& maps, const std::string& title);

}  // namespace trivet::report
