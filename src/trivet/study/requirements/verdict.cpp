// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "trivet/design/design_rules.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/text/document.h"
#include "trivet/study/analyses/analysis_results.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/explain/explanation.h"
#include "trivet/study/requirements/amplification.h"
#include "trivet/study/requirements/element_verdict.h"
#include "trivet/study/requirements/requirement_values.h"
#include "trivet/study/requirements/single_mount_forces.h"

namespace trivet::study {
namespace {

/// The judged result that governs, by the rule of maps: violated ones before met ones, ties in their order.
std::optional<std::size_t> least_margin(const std::vector<RequirementResult>& results) {
  std::vector<std::size_t> judged;
  std::vector<double> margins;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (!results[i].value) continue;
    judged.push_back(i);
    margins.push_back(results[i].margin);
  }
  if (judged.empty()) return std::nullopt;
  return judged[design::governing(margins).rule];
}

/// The band of the requirements, if an amplitude is limited over it.
std::optional<assembly::Band> common_band(const project::Analyses& analyses,
                                          const std::vector<RequirementResult>& results) {
  if (!analyses.requirements) return std::nullopt;
  const project::Requirements& required = *analyses.requirements;
  const bool applies = !required.limit_lines.empty() ||
      std::ranges::any_of(required.limits, [](const auto& limit) { return !limit.band && !limit.speed; }) ||
      std::ranges::find(results, RequirementKind::mount_dynamic_deflection, &RequirementResult::kind) != results.end();
  return applies ? required.band : std::nullopt;
}

/// What causes a governing amplitude or peak, in words; empty if it is no peak.
StatedWords cause_of(const project::Case& variant, const RequirementResult& result) {
  const bool clearance = result.kind == RequirementKind::clearance,
             explained =
                 clearance || result.kind == RequirementKind::amplitude || result.kind == RequirementKind::no_peak;
  if (!explained || !result.angular_frequency || result.order > 0) return {};
  constexpr double same_peak = 1e-6;  // of its frequency: both searches refine it to round-off
  constexpr int all = 1000;
  try {
    const Explanation found = explanation(
        variant, {.of = {clearance ? result.subject + "." + model::approach_component : result.subject}, .most = all});
    for (const ExplainedPeak& peak : found.peaks)
      if (std::abs(peak.peak.angular_frequency - *result.angular_frequency) <= same_peak * *result.angular_frequency)
        return peak.sentence;
  } catch (const foundation::NotComputable&) {  // the verdict stands without its cause
  }
  return {};
}

/// What happens at the speeds of the machine, for those who ask for the verdict alone.
void tell_operation(const project::Case& variant, const foundation::Progress& progress, CaseVerdict& judged) {
  try {
    judged.operation =
        operation_result(CaseContext(variant.system, progress), *variant.analyses.operation, judged.warnings);
  } catch (const foundation::NotComputable& reason) {
    judged.warnings.warning(reason.what(), "not computed", "", "");
  }
}

}  // namespace

bool is_judged_in_a_run(const project::Case& variant) {
  const project::Analyses& analyses = variant.analyses;
  return analyses.requirements || judges_operation(analyses) ||
      (analyses.operation && !(analyses.limits.empty() && analyses.limit_lines.empty())) ||
      !variant.system.description().clearances.empty();
}

bool has_something_to_judge(const project::Case& variant) {
  return is_judged_in_a_run(variant) || !variant.analyses.limits.empty() || !variant.analyses.limit_lines.empty();
}

std::vector<std::string> cases_to_hold(const project::Project& project) {
  const project::Case& base = project.base();
  const auto has_to_hold = [&](const project::Case& variant) {
    const auto& own = variant.analyses.requirements;
    const project::Node* table = variant.written.find("requirements");
    const bool names_cases = base.analyses.requirements || (table && table->find("hold_in"));
    if (own && names_cases) return std::ranges::find(own->hold_in, variant.name) != own->hold_in.end();
    return own || &variant == &base || has_something_to_judge(variant);
  };
  std::vector<std::string> names;
  for (const project::Case& variant : project.cases)
    if (has_to_hold(variant)) names.push_back(variant.name);
  return names;
}

CaseVerdict case_verdict(const project::Case& variant, const std::vector<std::string>& hold_in,
                         const foundation::Progress& progress) {
  const CaseContext context(variant.system, progress);
  CaseVerdict result;
  result.case_name = variant.name;
  result.display = variant.display;
  result.decides = std::ranges::find(hold_in, variant.name) != hold_in.end();
  result.warnings = variant.warnings;
  result.warnings.add(context.modes.warnings);
  result.results = requirement_values(context, variant.analyses, result.warnings);
  std::ranges::move(limits_that_miss_speeds(variant.system, variant.analyses, result.results),
                    std::back_inserter(result.results));
  result.warnings.add(rest_warnings(context, variant.analyses));
  result.warnings.add(amplification_warnings(context, variant.analyses));
  result.warnings.add(single_mount_warnings(context, variant.analyses));
  result.load_case = load_case(variant.name, context.system, context.assembled, variant.analyses);
  for (const RequirementResult& one : result.results)
    if (one.kind == RequirementKind::clearance && one.value && std::isfinite(*one.value))
      result.load_case.values.push_back({one.subject + ", gap left", "m", one.allowed - *one.value});
  result.common_band = common_band(variant.analyses, result.results);
  result.governing = least_margin(result.results);
  result.elements = element_verdicts(context.system, result.results);
  if (result.governing && std::isfinite(result.results[*result.governing].margin))
    result.cause = cause_of(variant, result.results[*result.governing]);
  return result;
}

const char* RequirementResult::level() const {
  switch (requirement_row(kind).shown) {
    case ShownValue::rms:
      return "rms";
    case ShownValue::at_its_level:
      return unit == "1" ? "" : project::level_ending(level_of_limit.value_or(project::Level::amplitude));
    case ShownValue::amplitude:
    case ShownValue::largest:
      return unit == "1" ? "" : "0-p";
    default:
      return "";
  }
}

bool RequirementResult::has_bound_in_units() const { return words.bound == "≤ " + value_words(allowed, unit); }

std::string RequirementResult::words_at_level() const {
  RequirementWords shown = words;
  if (*level() && has_bound_in_units()) shown.bound += std::string(" ") + level();
  return shown.text();
}

std::optional<project::Level> RequirementResult::level_for_people(const project::DisplayUnits& display) const {
  if (requirement_row(kind).shown != ShownValue::amplitude || unit == "1") return std::nullopt;
  return display.level ? *display.level : level_of_limit.value_or(project::shown_level(display, unit));
}

std::string RequirementResult::words_for_people(const project::DisplayUnits& display) const {
  const auto shown_at = level_for_people(display);
  if (!shown_at || !has_bound_in_units()) return words_at_level();
  RequirementWords shown = words;
  shown.bound = fmt::format("≤ {} {}", value_words(allowed * project::level_factor(*shown_at), unit),
                            project::level_ending(*shown_at));
  return shown.text();
}

std::size_t CaseVerdict::not_judged() const {
  return to_size(std::ranges::count_if(results, [](const RequirementResult& r) { return !r.value; }));
}

bool CaseVerdict::met() const {
  return std::ranges::all_of(results, [](const RequirementResult& r) { return r.met(); });
}

bool Verdict::met() const {
  return std::ranges::all_of(cases, [](const CaseVerdict& c) { return !c.decides || c.met(); });
}

std::optional<std::size_t> Verdict::governing_case() const {
  std::optional<std::size_t> least;
  const auto margin = [&](std::size_t i) { return cases[i].results[*cases[i].governing].margin; };
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (cases[i].decides && cases[i].governing && (!least || margin(i) < margin(*least))) least = i;
  return least;
}

Verdict verdict(const project::Project& project, const foundation::Progress& progress) {
  const foundation::InvalidInput nothing(
      "verdict: neither requirements nor limits nor clearances; add [requirements] with limits = {\"BODY.x\" = \"1 "
      "mm\"}, no_peak = "
      "\"coordinates\", damping_ratio = 0.03 …");
  if (std::ranges::none_of(project.cases, has_something_to_judge)) throw nothing;
  const std::vector<std::string> hold_in = cases_to_hold(project);
  Verdict result;
  for (std::size_t i = 0; i < project.cases.size(); ++i) {
    const project::Case& variant = project.cases[i];
    const foundation::Progress step = [&](std::string_view task, double fraction) {
      if (progress)
        progress(fmt::format("{}: {}", variant.name.empty() ? "base model" : variant.name, task),
                 (static_cast<double>(i) + fraction) / static_cast<double>(project.cases.size()));
    };
    result.cases.push_back(case_verdict(variant, hold_in, step));
    if (variant.analyses.operation) tell_operation(variant, step, result.cases.back());
  }
  if (std::ranges::all_of(result.cases, [](const CaseVerdict& judged) { return judged.results.empty(); }))
    throw nothing;  // such as [requirements] with `hold_in` alone
  std::vector<const LoadCase*> load_cases;
  for (const CaseVerdict& judged : result.cases) load_cases.push_back(&judged.load_case);
  result.envelope = envelope(load_cases);
  result.envelope.display = project.base().display;
  return result;
}

}  // namespace trivet::study
