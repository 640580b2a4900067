// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/project/analyses/analysis_table.h"
#include "trivet/study/analyses/case_context.h"

namespace trivet::study {

/// Computes the result of one analysis of project/analyses/analysis_table.h. Each is defined in NAME_run.cpp.
struct AnalysisRun {
  const char* name = nullptr;  ///< set by analysis_runs()
  const char* about;           ///< one line of help for its command
  const char* to_add;          ///< what the file must specify; nullptr: the defaults suffice
  /// Requests it as the file does, or with its defaults. Returns whether the file does.
  bool (*request)(const project::Analyses& of_file, project::Analyses& into);
  /// Nothing if it is not requested. @throws foundation::NotComputable, foundation::InvalidInput with the reason if
  /// there is no result; warnings of the computation are added to those of the case
  void (*compute)(const CaseContext& context, const project::Analyses& requested, CaseResults& into);
};

/// An analysis whose request and result are these fields, and that a function with their types computes: Result (const
/// CaseContext&, const Request&, foundation::Problems& warnings).
template <auto request, auto result, auto compute>
[[nodiscard]] constexpr AnalysisRun computed_by(const char* about, const char* to_add = nullptr) {
  return {nullptr, about, to_add,
          [](const project::Analyses& of_file, project::Analyses& into) {
            into.*request = of_file.*request;
            if (!(into.*request)) (into.*request).emplace();
            return (of_file.*request).has_value();
          },
          [](const CaseContext& context, const project::Analyses& requested, CaseResults& into) {
            if (requested.*request) into.*result = compute(context, *(requested.*request), into.warnings);
          }};
}

#define TRIVET_RUN(name) extern const AnalysisRun name##_run;
TRIVET_ANALYSES(TRIVET_RUN)
#undef TRIVET_RUN

/// All of them with their names, in the order of the table.
[[nodiscard]] const std::vector<AnalysisRun>& analysis_runs();

}  // namespace trivet::study
