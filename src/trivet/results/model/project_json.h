// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/study/whole_study.h"

namespace trivet::results {

/// The whole result file of `trivet run`: program, input, model, checks, and all results of all cases (docs/json.md).
[[nodiscard]] std::string results_json(const project::Project& project, const std::vector<study::CaseResults>& results);

/// The same with one case only.
[[nodiscard]] std::string case_results_json(const project::Project& project, const project::Case& variant,
                                            const study::CaseResults& results);

/// What the charts of the report page draw: names, limits, modes, peaks, and models of the curves instead of long
/// tables. Its tables and other figures are text of the page.
[[nodiscard]] std::string page_json(const project::Project& project, const std::vector<study::CaseResults>& results);

/// The model of a case as results.json has it.
[[nodiscard]] std::string model_json(const project::Case& variant);

/// {"ok", "problems": [...], "deep": [...]}: the verdict of `trivet check --json`; "deep" only if solvers were
/// compared.
[[nodiscard]] std::string problems_json(const foundation::Problems& problems,
                                        const std::vector<std::string>& free_motions,
                                        const std::vector<study::CaseCheck>& cases = {});

}  // namespace trivet::results
