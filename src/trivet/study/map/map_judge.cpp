// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/map/map_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <mutex>
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
                   const design::EvaluationOptions& options, SharedWork* shared)
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
  reports_.resize(cases_.size());
  // Kernels take less time for a design than its result in a file.
  if (!std::ranges::all_of(cases_, &MapCase::is_quick, [](const auto& one) -> const MapCase& { return *one; }))
    shared_ = shared;
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
  std::size_t size = count;
  for (const std::unique_ptr<MapCase>& one : cases_) size = std::min(size, one->piece());
  std::vector<DesignOutcome> outcomes(count);
  std::mutex adding;
  const auto points = [&](std::size_t first) {
    std::vector<design::DesignPoint> found;
    for (std::size_t k = first; k < std::min(first + size, count); ++k) found.push_back(point(k));
    return found;
  };
  const auto add = [&](std::size_t first, const Piece& piece) {
    std::ranges::copy(piece.outcomes, outcomes.begin() + static_cast<std::ptrdiff_t>(first));
    const std::lock_guard lock(adding);
    for (std::size_t c = 0; c < reports_.size(); ++c) reports_[c].add(piece.reports[c]);
  };
  foundation::ParallelOptions options{.size = size, .threads = threads_, .progress = progress, .task = "designs"};
  if (!shared_) {
    foundation::parallel_for(count, options,
                             [&](std::size_t first, std::size_t) { add(first, judged(first, points(first))); });
    return outcomes;
  }
  const std::vector<std::string> pieces =
      shared_->results((count + size - 1) / std::max<std::size_t>(size, 1), options,
                       [&](std::size_t piece) { return judged(piece * size, points(piece * size)).text(); });
  for (std::size_t piece = 0; piece < pieces.size(); ++piece) add(piece * size, Piece::of_text(pieces[piece]));
  return outcomes;
}

MapJudge::Piece MapJudge::judged(std::size_t first, const std::vector<design::DesignPoint>& points) const {
  Piece piece{std::vector<DesignOutcome>(points.size()), {}};
  Eigen::ArrayXXd margins(to_index(points.size()), to_index(rules_.size()));
  Eigen::Index rule = 0;
  for (const std::unique_ptr<MapCase>& one : cases_) {
    const auto own = to_index(one->rules().size());
    piece.reports.push_back(one->judge(first, points, margins.middleCols(rule, own), piece.outcomes.data()));
    rule += own;
  }
  std::vector<double> of_design(rules_.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!piece.outcomes[k].known()) continue;
    for (std::size_t r = 0; r < of_design.size(); ++r) of_design[r] = margins(to_index(k), to_index(r));
    const design::Governing least = design::governing(of_design);
    piece.outcomes[k].margin = design::rounded_margin(least.margin);
    piece.outcomes[k].governing = static_cast<std::uint8_t>(least.rule);
  }
  return piece;
}

std::string MapJudge::Piece::text() const {
  foundation::StoredWords words;
  words.whole(outcomes.size());
  for (const DesignOutcome& one : outcomes) {
    words.exact(static_cast<double>(one.margin));
    for (const unsigned number : {unsigned{one.governing}, unsigned{one.modes_in_band}, unsigned{one.modes_below}})
      words.whole(number);
  }
  words.whole(reports.size());
  for (const PieceReport& one : reports) one.store(words);
  return words.words();
}

MapJudge::Piece MapJudge::Piece::of_text(const std::string& text) {
  foundation::WordReader words(text);
  Piece piece;
  for (std::uint64_t left = words.whole(); left > 0; --left) {
    DesignOutcome& one = piece.outcomes.emplace_back();
    one.margin = static_cast<float>(words.exact());
    one.governing = static_cast<std::uint8_t>(words.whole());
    one.modes_in_band = static_cast<std::uint8_t>(words.whole());
    one.modes_below = static_cast<std::uint16_t>(words.whole());
  }
  for (std::uint64_t left = words.whole(); left > 0; --left) piece.reports.push_back(PieceReport::restored(words));
  return piece;
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
  design::EvaluationReport report = cases_.front()->report(reports_.front());
  for (std::size_t p = 1; p < cases_.size(); ++p) {
    const design::EvaluationReport further = cases_[p]->report(reports_[p]);
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
