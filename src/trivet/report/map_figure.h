// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/report/figures.h"
#include "trivet/study/design_map.h"

namespace trivet::report {

/// Map with regions by governing rule, the feasible region lighter with its boundary and lines of equal margin, and
/// cases as labelled points.
[[nodiscard]] Figure map_figure(const study::DesignMap& map, const std::string& title);

}  // namespace trivet::report
