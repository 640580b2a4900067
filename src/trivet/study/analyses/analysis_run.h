// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <any>
#include <memory>

#include "trivet/project/analyses/analysis_table.h"
#include "trivet/study/analyses/case_context.h"

namespace trivet::study {

/// Computes the result of one analysis of project/analyses/analysis_table.h. Each is defined in NAME_run.cpp.
struct AnalysisRun {
  const char* name = nullptr;  ///< set by analysis_runs()
  const char* about;           ///< one line of help for its command
  const char* to_add;          ///< what the file must specify; nullptr: the defaults suffice
  std::shared_ptr<const project::Analysis> (*by_default)();
  /// @throws foundation::NotComputable, foundation::InvalidInput with the reason if there is no result; warnings of the
  /// computation are added to the list
  std::any (*compute)(const CaseContext& context, const project::Analysis& request, foundation::Problems& warnings);
};

namespace detail {

template <typename Request, typename Result,
          Result (*compute)(const CaseContext&, const Request&, foundation::Problems&)>
std::any result_as_any(const CaseContext& context, const project::Analysis& request, foundation::Problems& warnings) {
  return compute(context, dynamic_cast<const Request&>(request), warnings);
}

template <auto compute>
struct Signature;
template <typename Request, typename Result,
          Result (*compute)(const CaseContext&, const Request&, foundation::Problems&)>
struct Signature<compute> {
  static constexpr auto any = result_as_any<Request, Result, compute>;
  static std::shared_ptr<const project::Analysis> by_default() { return std::make_shared<Request>(); }
};

}  // namespace detail

/// An analysis that a function with its own types computes: Result (const CaseContext&, const Request&,
/// foundation::Problems& warnings).
template <auto compute>
[[nodiscard]] constexpr AnalysisRun computed_by(const char* about, const char* to_add = nullptr) {
  return {nullptr, about, to_add, detail::Signature<compute>::by_default, detail::Signature<compute>::any};
}

#define TRIVET_RUN(name) extern const AnalysisRun name##_run;
TRIVET_ANALYSES(TRIVET_RUN)
#undef TRIVET_RUN

/// All of them with their names, in the order of the table.
[[nodiscard]] const std::vector<AnalysisRun>& analysis_runs();

}  // namespace trivet::study
