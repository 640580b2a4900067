// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/study/whole_study.h"

namespace trivet::results {

/// The whole result file of `trivet run`: program, input, model, checks, and all answers of all cases (docs/json.md).
[[nodiscard]] std::string results_json(const project::Project& project, const std::vector<study::Answers>& answers);

/// The part for the report page: models instead of long tables of curves, without the answers that are static figures
/// in the page.
[[nodiscard]] std::string page_json(const project::Project& project, const std::vector<study::Answers>& answers);

/// {"ok", "problems": [...], "deep": [...]}: the verdict of `trivet check --json`; "deep" only if solvers were
/// compared.
[[nodiscard]] std::string problems_json(const foundation::Problems& problems,
                                        const std::vector<std::string>& free_motions,
                                        const std::vector<study::CaseCheck>& cases = {});

}  // namespace trivet::results
