// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/project/project.h"
#include "trivet/study/analyses/case_results.h"
#include "trivet/study/map/map_curves.h"

namespace trivet::report {

/// Of each case of a report: the curves of designs of its map, if it has one.
using CaseMapCurves = std::vector<std::optional<study::MapCurves>>;

/// Curves of the designs of every map that a report in full shows, small enough for its page.
[[nodiscard]] CaseMapCurves case_map_curves(const project::Project& project,
                                            const std::vector<study::CaseResults>& results,
                                            const foundation::Progress& progress);

/// What the page needs to draw the design under the point of a map (web/src/report/map_point.js): per case null, or the
/// stored designs with their verdicts and the numbers of their curves. Long lists are base64 of little-endian numbers.
[[nodiscard]] std::string map_point_json(const std::vector<study::CaseResults>& results, const CaseMapCurves& curves);

/// Is there any map whose point can be moved?
[[nodiscard]] bool has_map_point(const CaseMapCurves& curves);

}  // namespace trivet::report
