// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/map/design_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

#include "trivet/design/crossings.h"
#include "trivet/design/drawn_grid.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/project/model_number.h"
#include "trivet/study/map/map_judge.h"
#include "trivet/study/map/map_warnings.h"
#include "trivet/study/requirements/unbounded_peaks.h"
#include "trivet/study/requirements/verdict.h"

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
  const std::vector<std::string> hold_in = cases_to_hold(project);
  std::vector<MapMark> all;
  std::vector<const project::Case*> cases;
  for (const project::Case& c : project.cases) {
    const bool listed = request.cases && std::ranges::find(*request.cases, c.name) != request.cases->end();
    MapMark mark{c.name, project::ModelNumber(request.x).read(c), project::ModelNumber(request.y).read(c), false, {},
                 ""};
    if (request.cases ? !listed : !mark.placed()) continue;
    mark.has_own_rules = has_other_rules(c, request);
    mark.decides = !c.analyses.requirements || std::ranges::find(hold_in, c.name) != hold_in.end();
    all.push_back(std::move(mark));
    cases.push_back(&c);
  }
  foundation::parallel_for(all.size(), {.size = 1, .threads = threads, .progress = progress, .task = "cases"},
                           [&](std::size_t k, std::size_t) { judge(*cases[k], evaluation, all[k]); });
  return all;
}

namespace {

design::DesignPoint value_at(const project::MapRequest& request, const design::MapPlace& place) {
  return {request.x.at(place.x), request.y.at(place.y)};
}

/// Does the file give the band of a map in Hz, in the first table that has one?
bool has_band_in_hertz(const project::Case& variant) {
  for (const char* table : {"analyses.map", "requirements", "analyses.response"}) {
    const project::Node* band = project::deepest(variant.document, table).find("band");
    if (!band || band->kind != project::Node::Kind::array) continue;
    return std::ranges::any_of(band->items, [](const project::Node& end) {
      return end.kind == project::Node::Kind::text && end.text.ends_with("Hz");
    });
  }
  return false;
}

void count(DesignMap& map) {
  map.shares.resize(map.rules.size());
  for (std::size_t k = 0; k < map.outcomes.size(); ++k) {
    const design::DesignOutcome& outcome = map.outcomes[k];
    if (!outcome.known()) {
      ++map.unknown;
      continue;
    }
    map.feasible_designs += outcome.feasible();
    if (std::isfinite(outcome.margin))
      ++(outcome.feasible() ? map.shares[outcome.governing].feasible : map.shares[outcome.governing].infeasible);
  }
  if (const auto best = design::best_design(map.drawn, map.outcomes)) {
    map.best = best->design;
    map.without_bound = best->without_bound;
    map.equals = best->equals;
  }
  map.steep = design::steep_neighbours(map.grid, map.rules, map.outcomes);
}

}  // namespace

design::DesignPoint DesignMap::point(std::size_t design) const {
  const auto nx = to_size(grid.nx);
  return value_at(request, grid.place(static_cast<int>(design % nx), static_cast<int>(design / nx)));
}

DesignMap design_map(const project::Project& project, const project::Case& variant, const project::MapRequest& request,
                     const MapOptions& options, const foundation::Progress& progress) {
  DesignMap map;
  map.case_name = variant.name;
  map.request = request;
  map.in_hertz = has_band_in_hertz(variant);
  map.display = variant.display;
  map.grid = {options.nx > 0 ? options.nx : request.x.points, options.ny > 0 ? options.ny : request.y.points};
  map.request.x.points = map.grid.nx;
  map.request.y.points = map.grid.ny;
  map.drawn = design::drawn_grid(map.grid);
  refuse_unbounded_peaks(variant, map.request);
  MapJudge evaluation(project, variant, map.request, options.evaluation, options.shared);
  map.rules = evaluation.rules();
  map.outcomes = evaluation.evaluate(map.grid.count(), [&](std::size_t k) { return map.point(k); }, progress);
  map.report = evaluation.report();
  count(map);
  if (map.unknown == map.outcomes.size())
    throw foundation::NotComputable(
        fmt::format("map: none of the {} designs could be computed; the first: {}", map.outcomes.size(),
                    map.report.missing.empty() ? "no reason was given" : map.report.missing.front().words));
  const std::function<bool(std::size_t)> feasible = [&](std::size_t k) { return map.outcomes[k].feasible(); };
  const std::vector<design::CrossedEdge> edges = design::crossed_edges(map.grid, feasible);
  const design::JudgePlaces judge = [&](const std::vector<design::MapPlace>& places,
                                        const foundation::Progress& of_boundary) {
    return evaluation.evaluate(
        places.size(), [&](std::size_t k) { return value_at(map.request, places[k]); }, of_boundary);
  };
  const std::vector<double> crossing = design::boundary_crossings(map.grid, map.outcomes, edges, judge, progress);
  const auto connected = [&](int i, int j) {
    double sum = 0;
    for (const std::size_t k :
         {map.grid.index(i, j), map.grid.index(i + 1, j), map.grid.index(i, j + 1), map.grid.index(i + 1, j + 1)})
      sum += design::boundary_level(map.outcomes[k]);
    return sum >= 0;
  };
  map.band_crossings = design::band_crossings(map.grid, map.outcomes, judge, progress);
  map.feasible = design::contours(map.grid, feasible, edges, crossing, connected);
  map.boundary_tolerance = design::boundary_tolerance;
  if (map.best)
    map.margin_lines =
        design::margin_lines(map.drawn, map.outcomes, static_cast<double>(map.outcomes[*map.best].margin));
  map.marks = map_marks(project, map.request, evaluation, options.evaluation.threads, progress);
  map.warnings = map_warnings(variant, map);
  map.warnings.add(evaluation.warnings());
  return map;
}

std::vector<DesignMap> design_maps(const project::Project& project, const project::Case& variant,
                                   const project::MapRequest& request, const MapOptions& options,
                                   const foundation::Progress& progress) {
  std::vector<DesignMap> maps;
  for (std::size_t k = 0; k < request.pairs.size(); ++k) {
    const project::MapRequest one = request.of_pair(k);
    const foundation::Progress step = [&](std::string_view task, double fraction) {
      if (progress)
        progress(fmt::format("{} of {} maps: {}", k + 1, request.pairs.size(), task),
                 (static_cast<double>(k) + fraction) / static_cast<double>(request.pairs.size()));
    };
    maps.push_back(design_map(project, variant, one, options, step));
  }
  return maps;
}

bool has_own_map(const project::Project& project, const project::Case& variant) {
  const std::optional<project::MapRequest>& of_base = project.base().analyses.map;
  return variant.analyses.map &&
      (variant.name == project.base().name || !of_base || !(*variant.analyses.map == *of_base));
}

}  // namespace trivet::study
