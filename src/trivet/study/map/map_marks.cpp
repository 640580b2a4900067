// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/map/map_marks.h"

#include <algorithm>
#include <functional>
#include <tuple>

#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/project/model_number.h"
#include "trivet/study/map/map_judge.h"

namespace trivet::study {
namespace {

/// Reason why `work` failed; empty if it succeeded.
std::string failure_reason(const std::function<void()>& work) {
  try {
    work();
  } catch (const foundation::NotComputable& reason) {
    return reason.what();
  } catch (const foundation::InvalidInput& reason) {
    return reason.what();
  }
  return "";
}

void judge(const project::Case& variant, const MapJudge& evaluation, MapMark& mark) {
  // If the comparison fails, the case does not count as a design of this map.
  static_cast<void>(failure_reason(
      [&] { mark.of_this_model = mark.placed() && evaluation.is_at(variant.system, {*mark.x, *mark.y}); }));
  mark.failure = failure_reason([&] {
    const auto design = mark.of_this_model ? std::optional(design::DesignPoint{*mark.x, *mark.y}) : std::nullopt;
    mark.judged = evaluation.judged_design(variant.system, design);
  });
}

/// Does the map of this case differ, apart from grids and lists of cases?
bool has_other_rules(const project::Case& variant, const project::MapRequest& request) {
  if (!variant.analyses.map) return false;
  project::MapRequest own = *variant.analyses.map;
  if (!own.pairs.empty()) std::tie(own.x, own.y) = std::tie(request.x, request.y);  // of any of its pairs
  own.pairs = request.pairs;
  own.x.points = request.x.points;
  own.y.points = request.y.points;
  own.cases = request.cases;
  return !(own == request);
}

}  // namespace

std::vector<MapMark> map_marks(const project::Project& project, const project::MapRequest& request,
                               const MapJudge& evaluation, int threads, const foundation::Progress& progress) {
  std::vector<MapMark> all;
  std::vector<const project::Case*> cases;
  for (const project::Case& c : project.cases) {
    const bool listed = request.cases && std::ranges::find(*request.cases, c.name) != request.cases->end();
    MapMark mark{c.name, project::ModelNumber(request.x).read(c), project::ModelNumber(request.y).read(c), false, {},
                 ""};
    if (request.cases ? !listed : !mark.placed()) continue;
    mark.has_own_rules = has_other_rules(c, request);
    all.push_back(std::move(mark));
    cases.push_back(&c);
  }
  foundation::parallel_for(all.size(), {.size = 1, .threads = threads, .progress = progress, .task = "cases"},
                           [&](std::size_t k, std::size_t) { judge(*cases[k], evaluation, all[k]); });
  return all;
}

}  // namespace trivet::study
