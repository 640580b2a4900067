// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/map/map_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "trivet/foundation/constants.h"
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

/// Another rule of a design. As in design::governing, the first within a tie of the least margin governs, and violated
/// rules go before met ones.
void consider(double margin, std::size_t rule, DesignOutcome& outcome) {
  const bool less = margin < outcome.margin * (1 - design::tie_of_margins) || (margin < 1 && outcome.margin >= 1);
  if (less) {
    outcome.margin = design::rounded_margin(margin);
    outcome.governing = static_cast<std::uint8_t>(rule);
  }
}

const foundation::Problem& first_error(const foundation::Problems& problems) {
  return *std::ranges::find(problems.list(), foundation::Severity::error, &foundation::Problem::severity);
}

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

std::string words_of(const std::vector<design::MapRule>& rules, std::size_t first, std::size_t last) {
  constexpr std::size_t most = 4;
  std::string words;
  for (std::size_t r = first; r < std::min(last, first + most); ++r)
    words += (r == first ? "" : ", ") + rules[r].stated();
  return last - first > most ? words + fmt::format(" and {} more", last - first - most) : words;
}

}  // namespace

MapJudge::Part::Part(const project::Case& of_case, project::MapRequest requested,
                     const design::EvaluationOptions& options)
    : variant(of_case),
      request(std::move(requested)),
      evaluation(variant, request, options, MapRequirements::frequencies(request, of_case.system)),
      requirements(variant, request, evaluation.has_family()) {}

MapJudge::MapJudge(const project::Project& project, const project::Case& variant, const project::MapRequest& request,
                   const design::EvaluationOptions& options)
    : threads_(options.threads) {
  add_part(variant, request, options);
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
    add_part(variant, request_in(variant, request), options);
  } catch (const foundation::NotComputable& reason) {
    throw refused(reason.what());
  } catch (const foundation::InvalidInput& reason) {
    throw refused(reason.what());
  }
}

void MapJudge::add_part(const project::Case& variant, const project::MapRequest& request,
                        const design::EvaluationOptions& options) {
  Part& part = *parts_.emplace_back(std::make_unique<Part>(variant, request, options));
  part.first_rule = rules_.size();
  for (const auto* rules : {&part.evaluation.rules(), &part.requirements.rules()})
    for (design::MapRule rule : *rules) {
      if (parts_.size() > 1) rule.set_case(variant.name);
      rules_.push_back(std::move(rule));
    }
}

std::vector<DesignOutcome> MapJudge::evaluate(std::size_t count,
                                              const std::function<design::DesignPoint(std::size_t)>& point,
                                              const foundation::Progress& progress) {
  if (parts_.size() == 1 && parts_.front()->requirements.is_empty())
    return parts_.front()->evaluation.evaluate(count, point, progress);
  Points points;
  for (std::size_t k = 0; k < count; ++k) points.push_back(point(k));
  Outcomes all(count, DesignOutcome{std::numeric_limits<float>::infinity(), 0});
  for (const std::unique_ptr<Part>& part : parts_) {
    if (!part->evaluation.rules().empty()) {
      const Outcomes here = part->evaluation.evaluate(count, point, progress);
      for (std::size_t k = 0; k < count; ++k) {
        if (part == parts_.front() || (all[k].known() && !here[k].known())) all[k] = here[k];
        else if (all[k].known()) consider(here[k].margin, part->first_rule + here[k].governing, all[k]);
      }
    }
    judge_frequencies(*part, points, all);
    if (part->requirements.first_by_matrices() == 0) continue;
    foundation::parallel_for(count, {.threads = threads_, .progress = progress, .task = "requirements"},
                             [&](std::size_t first, std::size_t last) {
                               for (std::size_t k = first; k < last; ++k)
                                 if (all[k].known()) judge_separately(*part, k, points[k], Kinds::others, all[k]);
                             });
  }
  return all;
}

void MapJudge::judge_frequencies(const Part& part, const Points& points, Outcomes& outcomes) {
  const std::size_t first = part.requirements.first_by_matrices();
  if (first == part.requirements.rules().size()) return;
  constexpr std::size_t piece = 256;
  foundation::parallel_for(points.size(), {.size = piece, .threads = threads_}, [&](std::size_t from, std::size_t to) {
    const Eigen::ArrayXXd margins = part.evaluation.frequency_margins(
        {points.begin() + static_cast<std::ptrdiff_t>(from), points.begin() + static_cast<std::ptrdiff_t>(to)});
    for (std::size_t k = from; k < to; ++k) {
      if (!outcomes[k].known()) continue;
      const auto of_design = margins.row(to_index(k - from));
      if (of_design.isNaN().any()) {
        judge_separately(part, k, points[k], Kinds::frequencies, outcomes[k]);
        continue;
      }
      for (Eigen::Index r = 0; r < of_design.size(); ++r)
        consider(of_design(r), part.first_requirement() + first + to_size(r), outcomes[k]);
    }
  });
}

void MapJudge::judge_separately(const Part& part, std::size_t index, const design::DesignPoint& point, Kinds kinds,
                                DesignOutcome& outcome) {
  ++separately_;
  const std::string of_case = &part == parts_.front().get() ? "" : " in case " + foundation::quoted(part.variant.name);
  const auto refuse = [&](const std::string& rule, const std::string& words, std::uint8_t kind) {
    missing_.note(index, rule + of_case, words + of_case);
    outcome = {0, kind};
  };
  const auto system = judging::changed_system(
      part.variant, {{project::ModelNumber(part.request.x), point.x}, {project::ModelNumber(part.request.y), point.y}});
  if (!system) {
    const foundation::Problem& first = first_error(system.error());
    return refuse(first.subject + ": " + first.rule,
                  fmt::format("{}: {}; {}", first.subject, first.finding, first.rule), DesignOutcome::no_model);
  }
  try {
    const bool others = kinds == Kinds::others;
    const std::vector<RequirementResult> results =
        others ? part.requirements.separate_results(*system) : part.requirements.frequency_results(*system);
    const std::size_t first = part.first_requirement() + (others ? 0 : part.requirements.first_by_matrices());
    for (std::size_t r = 0; r < results.size(); ++r) {
      if (!results[r].value) {
        const std::string words = results[r].words.text() + ": " + results[r].reason;
        return refuse(words, words, DesignOutcome::not_computed);
      }
      consider(results[r].margin, first + r, outcome);
    }
  } catch (const foundation::NotComputable& reason) {
    refuse(reason.what(), reason.what(), DesignOutcome::not_computed);
  } catch (const foundation::InvalidInput& reason) {
    refuse(reason.what(), reason.what(), DesignOutcome::not_computed);
  }
}

bool MapJudge::is_at(const model::System& system, const design::DesignPoint& point) const {
  return parts_.front()->evaluation.is_at(system, point);
}

void MapJudge::append(const Part& part, const model::System& system, design::JudgedDesign& result) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (!part.evaluation.rules().empty()) {
    design::JudgedDesign judged = part.evaluation.judged_design(system);
    if (result.margins.empty()) {
      result = std::move(judged);
    } else {
      const auto add = [](std::vector<double>& all, const std::vector<double>& more) {
        all.insert(all.end(), more.begin(), more.end());
      };
      add(result.rules.values, judged.rules.values);
      add(result.rules.angular_frequencies, judged.rules.angular_frequencies);
      add(result.margins, judged.margins);
    }
  }
  if (part.requirements.is_empty()) return;
  for (const RequirementResult& requirement : part.requirements.results(system)) {
    if (!requirement.value) throw foundation::NotComputable(requirement.words.text() + ": " + requirement.reason);
    result.rules.values.push_back(*requirement.value);
    result.rules.angular_frequencies.push_back(requirement.angular_frequency.value_or(none));
    result.margins.push_back(requirement.margin);
  }
}

design::JudgedDesign MapJudge::judged_design(const model::System& system,
                                             const std::optional<design::DesignPoint>& design) const {
  design::JudgedDesign result;
  append(*parts_.front(), system, result);
  for (std::size_t p = 1; design && p < parts_.size(); ++p) {
    const Part& part = *parts_[p];
    const auto there = judging::changed_system(
        part.variant,
        {{project::ModelNumber(part.request.x), design->x}, {project::ModelNumber(part.request.y), design->y}});
    if (!there)
      throw foundation::NotComputable("in case " + foundation::quoted(part.variant.name) + ": " +
                                      first_error(there.error()).finding);
    append(part, *there, result);
  }
  result.rules.values.resize(rules_.size(), std::numeric_limits<double>::quiet_NaN());
  result.rules.angular_frequencies.resize(rules_.size(), std::numeric_limits<double>::quiet_NaN());
  result.margins.resize(rules_.size(), foundation::infinity);
  result.governing = design::governing(result.margins);
  return result;
}

design::EvaluationReport MapJudge::report() const {
  design::EvaluationReport report = parts_.front()->evaluation.report();
  report.with_requirements = separately_;
  for (const std::unique_ptr<Part>& part : parts_) {
    std::string of_case;
    if (part != parts_.front()) {
      of_case = " in case " + foundation::quoted(part->variant.name);
      if (!part->evaluation.rules().empty())
        report.further.push_back(of_case.substr(1) + ": " + part->evaluation.report().summary());
      for (design::MissingReason reason : part->evaluation.report().missing) {
        reason.words += of_case;
        report.missing.push_back(std::move(reason));
      }
    }
    const std::vector<design::MapRule>& rules = part->requirements.rules();
    const std::size_t by_matrices = part->requirements.first_by_matrices();
    if (by_matrices < rules.size())
      report.further.push_back(
          fmt::format("natural frequencies{} of the {}: {}", of_case,
                      part->evaluation.rules().empty() ? part->evaluation.report().family : "matrices as sums",
                      words_of(rules, by_matrices, rules.size())));
    if (by_matrices > 0)
      report.further.push_back(fmt::format("judged design by design{}: {}", of_case, words_of(rules, 0, by_matrices)));
  }
  for (const design::MissingReason& reason : missing_.list()) report.missing.push_back(reason);
  return report;
}

foundation::Problems MapJudge::warnings() const {
  foundation::Problems all = warnings_;
  for (const std::unique_ptr<Part>& part : parts_) all.add(part->requirements.warnings());
  return all;
}

}  // namespace trivet::study
