// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/results/design/judgements.h"
#include "trivet/study/analyses/case_results.h"
#include "trivet/study/whole_study.h"

namespace trivet::report {

/// A case with its results and what the page states about it in several places.
struct ShownCase {
  const project::Case& variant;
  const study::CaseResults& results;
  std::vector<study::CheckLine> checks;

  [[nodiscard]] std::string name() const;
  /// The checks that failed, one sentence each.
  [[nodiscard]] std::vector<std::string> failed_checks() const;
  [[nodiscard]] std::vector<foundation::Problem> warnings() const;
  [[nodiscard]] std::size_t limits() const;
  [[nodiscard]] std::size_t exceeded_limits() const;
  /// Has it an unstable mode or a growing root?
  [[nodiscard]] bool grows() const;
};

[[nodiscard]] std::vector<ShownCase> shown_cases(const project::Project& project,
                                                 const std::vector<study::CaseResults>& results);

using results::count_words;

}  // namespace trivet::report
