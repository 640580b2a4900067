// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/optimum_warnings.h"

#include <fmt/format.h>

#include <algorithm>

#include "trivet/foundation/invalid_input.h"
#include "trivet/study/requirements/requirement_values.h"
#include "trivet/study/requirements/verdict.h"

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
      warnings.warning(
          "optimize: " + result.words.text(), "the result is zero except for round-off, given and at the optimum",
          "its requirement has no effect", "check the directions of forces and constraints, or remove the requirement");
    }
  if (all > 0 && zero == all)
    throw foundation::NotComputable(
        "optimize: all results that are required to be small are zero in every design; check the directions of forces "
        "and constraints");
  warnings.sort_by_origin();
  return warnings;
}

bool all_met(const std::vector<CaseVerdict>& verdicts) {
  return std::ranges::all_of(verdicts, [](const CaseVerdict& one) { return one.met(); });
}

/// A warning if the search did not reach the given design: its ranges do not contain it, or no start led there.
foundation::Problems better_given_design(const Optimization& found) {
  foundation::Problems warnings;
  constexpr double noticeable = 1e-6;                                      // relative
  if (found.minimized_kind == project::Minimized::price) return warnings;  // the margin of dearer mounts
  if (!found.objective_before || (found.minimizes && !all_met(found.before))) return warnings;
  const double before = *found.objective_before, after = found.objective_after;
  const bool better = found.minimizes ? before < after * (1 - noticeable) : before > after * (1 + noticeable);
  const std::string unit = found.objective_unit.empty() ? "" : " " + found.objective_unit;
  if (better)
    warnings.warning(
        "optimize",
        fmt::format("the given design is better than the optimum: {} {:.6g}{} given, {:.6g}{} at the optimum",
                    found.minimizes ? "minimised" : "least margin", before, unit, after, unit),
        "the ranges and the mounts to choose from do not contain the given design, or no start led to it",
        "widen the ranges, add the given mounts to the choices, or keep the given design");
  return warnings;
}

}  // namespace

foundation::Problems optimum_warnings(const project::Project& project, const Optimization& found) {
  foundation::Problems warnings = idle_parameters(project, found);
  if (found.cut_short)
    warnings.warning("optimize", "the search was ended before it was complete",
                     "this is the best design so far, and none of the climbs from it is finished",
                     "give it more time, or fewer starts, combinations or parameters");
  for (const CaseVerdict& judged : found.after) warnings.add(missed_speed_warnings(judged.results));
  warnings.add(zero_results(found));
  warnings.add(better_given_design(found));
  return warnings;
}

}  // namespace trivet::study
