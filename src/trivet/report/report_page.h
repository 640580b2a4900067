// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/study/answers.h"

namespace trivet::report {

/// A self-contained HTML page that works from a file without network. `results` is the text of results::page_json (or
/// of results.json), which the script of the page reads; without scripts the page shows the overview figure, the input
/// identification and the further answers of the first case.
[[nodiscard]] std::string report_page(const project::Project& project, const std::vector<study::Answers>& answers,
                                      const std::string& results);

}  // namespace trivet::report
