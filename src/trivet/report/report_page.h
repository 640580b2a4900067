// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/study/answers.h"

namespace trivet::report {

/// A self-contained HTML page: works from a file without network. `results` is the text of study::page_json (or of
/// results.json), which the page's script reads; without scripts the overview figure, the input identification and the
/// further answers of the first case still show.
[[nodiscard]] std::string report_page(const project::Project& project, const std::vector<study::Answers>& answers,
                                      const std::string& results);

}  // namespace trivet::report
