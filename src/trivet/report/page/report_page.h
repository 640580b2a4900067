// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/project/report_settings.h"
#include "trivet/report/map/map_point_json.h"
#include "trivet/study/analyses/case_results.h"

namespace trivet::report {

/// A self-contained HTML page that works from a file without network. `results` is the text of results::page_json,
/// from which the script of the page draws its charts; without scripts the page shows all else of the first case. The
/// short form has neither, and only its first parts. With `map_curves`, the points of its maps can be moved.
[[nodiscard]] std::string report_page(const project::Project& project,
                                      const std::vector<study::CaseResults>& case_results, const std::string& results,
                                      project::ReportForm form = project::ReportForm::full,
                                      const CaseMapCurves& map_curves = {});

}  // namespace trivet::report
