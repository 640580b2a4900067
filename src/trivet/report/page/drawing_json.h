// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/report/map/map_point_json.h"
#include "trivet/study/analyses/case_results.h"

namespace trivet::report {

/// What the page's charts share with the figures for print: {"strokes": [{"colour", "dash"}], "units": {unit:
/// {"quantity", "multiples": [[size, name]]}}, "groups": per case [{"name", "rows": [[{"label", "curve"}]],
/// "logarithmic": of each row}], "amplitude_rule"}, and of the designs of maps "design_groups".
[[nodiscard]] std::string drawing_json(const std::vector<study::CaseResults>& results,
                                       const CaseMapCurves& map_curves = {});

}  // namespace trivet::report
