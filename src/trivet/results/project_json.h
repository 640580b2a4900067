// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/study/answers.h"

namespace trivet::results {

/// One check that the data passed or failed, in words.
struct CheckLine {
  std::string subject;
  std::string what;
  std::string value;
  bool passed = true;
  bool operator==(const CheckLine&) const = default;
};

/// Checks of every body and element of a case, with their figures.
[[nodiscard]] std::vector<CheckLine> check_lines(const project::Case& variant);

/// The whole result file of `trivet run`: program, input, model, checks, and all answers of all cases (docs/json.md).
[[nodiscard]] std::string results_json(const project::Project& project, const std::vector<study::Answers>& answers);

/// What the report page needs of it: models instead of long tables of curves, and nothing of the answers that stand in the page as static figures.
[[nodiscard]] std::string page_json(const project::Project& project, const std::vector<study::Answers>& answers);

/// Two solvers compared on one case.
struct CaseDeepCheck {
  std::string case_name;
  response::DeepCheck check;
};

/// {"ok", "problems": [...], "deep": [...]}: the verdict of `trivet check --json`; "deep" only where solvers were
/// compared.
[[nodiscard]] std::string problems_json(const foundation::Problems& problems,
                                        const std::vector<std::string>& free_motions,
                                        const std::vector<CaseDeepCheck>& deep = {});

}  // namespace trivet::results
