// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/map/map_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/first_error.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/judging/changed_case.h"
#include "trivet/project/analyses/map_requirements.h"
#include "trivet/study/requirements/overruled_cases.h"

namespace trivet::study {
namespace {

using design::DesignOutcome;

/// The rules of the map in a case of `hold_in`, on the axes of the base map.
project::MapRequest request_in(const project::Case& variant, const project::MapRequest& base) {
  project::MapRequest request =
      variant.analyses.map ? *variant.analyses.map : project::map_of_case(variant.analyses, base);
  request.x = base.x;
  request.y = base.y;
  return request;
}

/// Does a further case take both numbers of the map, and set neither itself? If not, its designs cannot be judged: a
/// warning, or an error if the file requests it. A case with limits alone is a point of the map, judged there.
bool takes_numbers(const project::Case& variant, const project::Case& base, const project::MapRequest& request,
                   bool as_requested, foundation::Problems& warnings) {
  constexpr double inside = 0.47;  // of the axis
  for (const project::DesignAxis* axis : {&request.x, &request.y}) {
    const project::ModelNumber number(*axis);
    if (number.read(variant)) continue;
    if (judging::changed_system(variant, {{number, axis->at(inside)}})) continue;
    const std::string finding =
        fmt::format("case {} has no number {}", foundation::quoted(variant.name), foundation::quoted(axis->parameter));
    if (as_requested)
      throw foundation::NotComputable("map: " + finding +
                                      ", so its designs cannot be judged there; add the number, or "
                                      "take the case out of requirements.hold_in");
    warnings.warning("map", finding, "clearances are judged in all cases that have both numbers of the map",
                     "judge this case separately by verdict, or list the cases in requirements.hold_in");
    return false;
  }
  const std::vector<OverruledCase> lost = overruled_in(variant, base, {request.x, request.y});
  if (lost.empty()) return true;
  if (!is_judged_in_a_run(variant)) return false;
  if (as_requested) throw foundation::InvalidInput(lost.front().refusal("map"));
  warnings.warning("map", lost.front().finding, "every design would undo the case, so none is judged in it",
                   "change another number in the case, such as stiffness_factor, or judge it separately by verdict");
  return false;
}

}  // namespace

MapJudge::MapJudge(const project::Project& project, const project::Case& variant, const project::MapRequest& request,
                   const design::EvaluationOptions& options)
    : threads_(options.threads) {
  add_case(variant, request, options);
  const std::vector<std::string> hold_in = cases_to_hold(project);
  if (variant.name.empty())
    for (const project::Case& further : project.cases) {
      const bool holds = !further.name.empty() && std::ranges::find(hold_in, further.name) != hold_in.end();
      const bool as_requested = further.analyses.requirements.has_value();
      if (holds && takes_numbers(further, variant, request, as_requested, warnings_))
        add_further(further, request, options);
    }
  if (rules_.size() > DesignOutcome::most_rules)
    throw foundation::NotComputable(fmt::format("map: {} rules in all cases of hold_in; a map has at most {}",
                                                rules_.size(), DesignOutcome::most_rules));
}

void MapJudge::add_further(const project::Case& variant, const project::MapRequest& request,
                           const design::EvaluationOptions& options) {
  const auto refused = [&](const std::string& reason) {
    return foundation::NotComputable("map: in case " + foundation::quoted(variant.name) + " of hold_in: " + reason);
  };
  try {
    add_case(variant, request_in(variant, request), options);
  } catch (const foundation::NotComputable& reason) {
    throw refused(reason.what());
  } catch (const foundation::InvalidInput& reason) {
    throw refused(reason.what());
  }
}

void MapJudge::add_case(const project::Case& variant, const project::MapRequest& request,
                        const design::EvaluationOptions& options) {
  cases_.push_back(std::make_unique<MapCase>(variant, request, options, !cases_.empty()));
  for (design::MapRule rule : cases_.back()->rules()) {
    if (cases_.size() > 1) rule.set_case(variant.name);
    rules_.push_back(std::move(rule));
  }
}

std::vector<DesignOutcome> MapJudge::evaluate(std::size_t count,
                                              const std::function<design::DesignPoint(std::size_t)>& point,
                                              const foundation::Progress& progress) {
  std::size_t piece = std::numeric_limits<std::size_t>::max();
  for (const std::unique_ptr<MapCase>& one : cases_) piece = std::min(piece, one->piece());
  std::vector<DesignOutcome> outcomes(count);
  foundation::parallel_for(count, {.size = piece, .threads = threads_, .progress = progress, .task = "designs"},
                           [&](std::size_t first, std::size_t last) {
                             std::vector<design::DesignPoint> points;
                             for (std::size_t k = first; k < last; ++k) points.push_back(point(k));
                             Eigen::ArrayXXd margins(to_index(points.size()), to_index(rules_.size()));
                             Eigen::Index rule = 0;
                             for (const std::unique_ptr<MapCase>& one : cases_) {
                               const auto own = to_index(one->rules().size());
                               one->judge(first, points, margins.middleCols(rule, own), &outcomes[first]);
                               rule += own;
                             }
                             std::vector<double> of_design(rules_.size());
                             for (std::size_t k = first; k < last; ++k) {
                               if (!outcomes[k].known()) continue;
                               for (std::size_t r = 0; r < of_design.size(); ++r)
                                 of_design[r] = margins(to_index(k - first), to_index(r));
                               const design::Governing least = design::governing(of_design);
                               outcomes[k].margin = design::rounded_margin(least.margin);
                               outcomes[k].governing = static_cast<std::uint8_t>(least.rule);
                             }
                           });
  return outcomes;
}

design::JudgedDesign MapJudge::judged_design(const model::System& system,
                                             const std::optional<design::DesignPoint>& design) const {
  design::JudgedDesign result;
  cases_.front()->add_judged(system, result);
  for (std::size_t p = 1; design && p < cases_.size(); ++p) {
    const auto there = cases_[p]->system_at(*design);
    if (!there)
      throw foundation::NotComputable("in case " + foundation::quoted(cases_[p]->name()) + ": " +
                                      foundation::error_of(there.error()).finding);
    cases_[p]->add_judged(*there, result);
  }
  result.rules.values.resize(rules_.size(), std::numeric_limits<double>::quiet_NaN());
  result.rules.angular_frequencies.resize(rules_.size(), std::numeric_limits<double>::quiet_NaN());
  result.margins.resize(rules_.size(), foundation::infinity);
  result.governing = design::governing(result.margins);
  return result;
}

design::EvaluationReport MapJudge::report() const {
  design::EvaluationReport report = cases_.front()->report();
  for (std::size_t p = 1; p < cases_.size(); ++p) {
    const design::EvaluationReport further = cases_[p]->report();
    report.with_requirements += further.with_requirements;
    report.further.insert(report.further.end(), further.further.begin(), further.further.end());
    report.missing.insert(report.missing.end(), further.missing.begin(), further.missing.end());
  }
  return report;
}

foundation::Problems MapJudge::warnings() const {
  foundation::Problems all = warnings_;
  for (const std::unique_ptr<MapCase>& one : cases_) all.add(one->warnings());
  return all;
}

}  // namespace trivet::study
