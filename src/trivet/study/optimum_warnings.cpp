// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimum_warnings.h"

#include "trivet/foundation/invalid_input.h"

namespace trivet::study {
namespace {

/// Warnings of parameters on which nothing depends where the search ended.
foundation::Problems idle_parameters(const project::Project& project, const Optimization& found) {
  foundation::Problems warnings;
  for (const OptimizedParameter& parameter : found.parameters) {
    if (!parameter.idle) continue;
    const std::string subject = "parameters." + parameter.axis.name;
    warnings
        .warning(subject, "changes nothing at the optimum",
                 "no value near deciding depends on it, so it keeps its given value",
                 "remove it, or require something that depends on it")
        .origin = project::deepest(project.base().written, subject).origin;
  }
  return warnings;
}

bool is_zero(const RequirementResult& result) {
  using Kind = RequirementKind;
  const bool of_motion = result.kind == Kind::amplitude || result.kind == Kind::rms || result.kind == Kind::largest ||
      result.kind == Kind::static_value;
  return of_motion && result.value == 0.0;
}

/// Warnings of requirements on results that are zero, given and at the optimum.
foundation::Problems zero_results(const Optimization& found) {
  foundation::Problems warnings;
  std::size_t all = 0, zero = 0;
  for (std::size_t c = 0; c < found.after.size(); ++c)
    for (std::size_t r = 0; r < found.after[c].results.size(); ++r, ++all) {
      const RequirementResult& result = found.after[c].results[r];
      if (!is_zero(result) || !is_zero(found.before[c].results[r])) continue;
      ++zero;
      warnings.warning("optimize: " + result.words, "the result is zero except for round-off, given and at the optimum",
                       "its requirement has no effect",
                       "check the directions of forces and constraints, or remove the requirement");
    }
  if (all > 0 && zero == all)
    throw foundation::NotComputable(
        "optimize: all results that are required to be small are zero in every design; check the directions of forces "
        "and constraints");
  warnings.sort_by_origin();
  return warnings;
}

}  // namespace

foundation::Problems optimum_warnings(const project::Project& project, const Optimization& found) {
  foundation::Problems warnings = idle_parameters(project, found);
  warnings.add(zero_results(found));
  return warnings;
}

}  // namespace trivet::study
