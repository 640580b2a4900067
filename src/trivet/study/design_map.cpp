// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/design_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/pieces.h"
#include "trivet/study/best_design.h"
#include "trivet/study/design_evaluation.h"
#include "trivet/study/design_parameter.h"
#include "trivet/study/steep_neighbours.h"

namespace trivet::study {
namespace {

constexpr double boundary_tolerance = 1e-6;  // of each axis
constexpr int most_steps = 80;               // bisection alone needs 20 of an axis of two points

/// A signed measure that crosses zero on the boundary; what has no model is well outside.
double level(const DesignOutcome& outcome) {
  constexpr double far = 3;
  if (!outcome.known() || !(outcome.margin > 0)) return -far;
  return std::clamp(std::log(static_cast<double>(outcome.margin)), -far, far);
}

/// Where the boundary passes one edge: between a and b, shares of the edge, with the levels there.
struct Bracket {
  double a = 0, b = 1, at_a = 0, at_b = 0;
  double tolerance = 0;
  int steps = 0;

  [[nodiscard]] bool done() const { return std::abs(b - a) <= tolerance || steps >= most_steps; }
  /// Regula falsi with the Illinois weights, every third step halving; never nearer to an end than half the tolerance.
  [[nodiscard]] double next() const {
    double t = steps % 3 == 2 ? 0.5 * (a + b) : a + (b - a) * at_a / (at_a - at_b);
    const double low = std::min(a, b) + 0.5 * tolerance, high = std::max(a, b) - 0.5 * tolerance;
    return std::clamp(std::isfinite(t) ? t : 0.5 * (a + b), std::min(low, high), std::max(low, high));
  }
  void see(double t, double value) {
    ++steps;
    if ((value >= 0) == (at_b >= 0)) {
      b = t;
      at_b = value;
      at_a *= 0.5;
    } else {
      a = b;
      at_a = at_b;
      b = t;
      at_b = value;
    }
  }
};

DesignPoint value_at(const MapRequest& request, const MapPlace& place) { return {request.x.at(place.x), request.y.at(place.y)}; }

MapPlace on_edge(const MapGrid& grid, const CrossedEdge& edge, double t) {
  MapPlace p = grid.place(edge.i, edge.j);
  (edge.upwards ? p.y : p.x) += t / ((edge.upwards ? grid.ny : grid.nx) - 1);
  return p;
}

/// Crossings of the boundary, all edges in step.
std::vector<double> refined_crossings(DesignEvaluation& evaluation, const MapRequest& request, const MapGrid& grid, const std::vector<DesignOutcome>& outcomes,
                                      const std::vector<CrossedEdge>& edges, const foundation::Progress& progress) {
  std::vector<Bracket> brackets;
  for (const CrossedEdge& e : edges) {
    const std::size_t to = e.upwards ? grid.index(e.i, e.j + 1) : grid.index(e.i + 1, e.j);
    brackets.push_back({0, 1, level(outcomes[grid.index(e.i, e.j)]), level(outcomes[to]), boundary_tolerance * ((e.upwards ? grid.ny : grid.nx) - 1), 0});
  }
  std::vector<std::size_t> open(edges.size());
  for (std::size_t e = 0; e < open.size(); ++e) open[e] = e;
  while (true) {
    std::erase_if(open, [&](std::size_t e) { return brackets[e].done(); });
    if (open.empty()) break;
    foundation::report_progress(progress, "boundary", 1 - static_cast<double>(open.size()) / static_cast<double>(edges.size()));
    std::vector<double> t;
    for (const std::size_t e : open) t.push_back(brackets[e].next());
    const foundation::Progress interruptible = [&](std::string_view, double) {
      foundation::report_progress(progress, "boundary", 1 - static_cast<double>(open.size()) / static_cast<double>(edges.size()));
    };
    const auto found = evaluation.evaluate(open.size(), [&](std::size_t k) { return value_at(request, on_edge(grid, edges[open[k]], t[k])); }, interruptible);
    for (std::size_t k = 0; k < open.size(); ++k) brackets[open[k]].see(t[k], level(found[k]));
  }
  std::vector<double> crossings;
  for (const Bracket& bracket : brackets) crossings.push_back(0.5 * (bracket.a + bracket.b));
  return crossings;
}

/// The number on an axis; a scale that is not written is 1.
std::optional<double> number_of(const Case& variant, const MapAxis& axis) {
  const std::vector<std::string> keys = path_keys(axis.parameter);
  const Node* node = behind(variant.document, keys);
  if (!node && (keys.back() == "scale" || keys.back() == "stiffening")) return 1.0;
  const auto written = node ? written_number(*node) : std::nullopt;
  return written ? in_unit(*written, axis.unit) : std::nullopt;
}

/// Why some work cannot be done; empty if it was.
std::string why_not(const std::function<void()>& work) {
  try {
    work();
  } catch (const foundation::NotComputable& reason) {
    return reason.what();
  } catch (const foundation::InvalidInput& reason) {
    return reason.what();
  }
  return "";
}

void judge(const Case& variant, const DesignEvaluation& evaluation, MapMark& mark) {
  mark.failure = why_not([&] { mark.judged = evaluation.judged(variant.system); });
  // What cannot be compared is not known to be a design of this map.
  static_cast<void>(why_not([&] { mark.of_this_model = mark.placed() && evaluation.is_at(variant.system, {*mark.x, *mark.y}); }));
}

std::vector<MapMark> marks(const Project& project, const MapRequest& request, const DesignEvaluation& evaluation, int threads, const foundation::Progress& progress) {
  std::vector<MapMark> all;
  std::vector<const Case*> cases;
  for (const Case& c : project.cases) {
    const bool listed = request.cases && std::find(request.cases->begin(), request.cases->end(), c.name) != request.cases->end();
    MapMark mark{c.name, number_of(c, request.x), number_of(c, request.y), false, {}, ""};
    if (request.cases ? !listed : !mark.placed()) continue;
    all.push_back(std::move(mark));
    cases.push_back(&c);
  }
  foundation::for_each_piece(all.size(), {1, threads, progress, "cases"}, [&](std::size_t k, std::size_t) { judge(*cases[k], evaluation, all[k]); });
  // The base model is a case too, but not twice in one place.
  const auto base = std::find_if(all.begin(), all.end(), [](const MapMark& m) { return m.name.empty(); });
  if (base != all.end() && std::any_of(all.begin(), all.end(), [&](const MapMark& m) { return !m.name.empty() && m.x == base->x && m.y == base->y && m.of_this_model == base->of_this_model; }))
    all.erase(base);
  return all;
}

void count(DesignMap& map) {
  map.shares.resize(map.rules.size());
  for (std::size_t k = 0; k < map.outcomes.size(); ++k) {
    const DesignOutcome& outcome = map.outcomes[k];
    if (!outcome.known()) {
      ++map.unknown;
      continue;
    }
    map.kept += outcome.kept();
    if (std::isfinite(outcome.margin)) ++(outcome.kept() ? map.shares[outcome.governing].kept : map.shares[outcome.governing].broken);
  }
  if (const auto best = best_design(map.drawn, map.outcomes)) {
    map.best = best->design;
    map.without_bound = best->without_bound;
    map.equals = best->equals;
  }
  map.steep = steep_neighbours(map.grid, map.rules, map.outcomes);
}

}  // namespace

DesignPoint DesignMap::point(std::size_t design) const {
  const auto nx = static_cast<std::size_t>(grid.nx);
  return value_at(request, grid.place(static_cast<int>(design % nx), static_cast<int>(design / nx)));
}

std::string feasible_words(const DesignMap& map) {
  const std::string share = fmt::format("{:.2f} %", 100 * map.feasible.area);
  const bool rounded_up = share == "100.00 %" && map.kept < map.outcomes.size();
  std::string text = fmt::format("Feasible: {} of the map, {} of {} designs", rounded_up ? "less than 100 %" : share, map.kept, map.outcomes.size());
  if (map.steep > 0)
    text += fmt::format("; between {} of neighbours that limits on amplitudes govern the margin changes more than tenfold: what lies between them, a resonance of little damping for instance, "
                        "may break a rule unseen; take more points there", map.steep == 1 ? "one pair" : fmt::format("{} pairs", map.steep));
  return text;
}

DesignMap design_map(const Project& project, const Case& variant, const MapRequest& request, const MapOptions& options, const foundation::Progress& progress) {
  DesignMap map;
  map.case_name = variant.name;
  map.request = request;
  map.grid = {options.nx > 0 ? options.nx : request.x.points, options.ny > 0 ? options.ny : request.y.points};
  map.request.x.points = map.grid.nx;
  map.request.y.points = map.grid.ny;
  map.drawn = drawn_grid(map.grid);
  DesignEvaluation evaluation(variant, map.request, options.evaluation);
  map.rules = evaluation.rules();
  map.outcomes = evaluation.evaluate(map.grid.count(), [&](std::size_t k) { return map.point(k); }, progress);
  map.report = evaluation.report();
  count(map);
  if (map.unknown == map.outcomes.size())
    throw foundation::NotComputable(fmt::format("map: none of the {} designs has an answer; the first: {}", map.outcomes.size(),
                                                map.report.missing.empty() ? "no reason was given" : map.report.missing.front().words));
  const std::function<bool(std::size_t)> kept = [&](std::size_t k) { return map.outcomes[k].kept(); };
  const std::vector<CrossedEdge> edges = crossed_edges(map.grid, kept);
  const std::vector<double> crossing = refined_crossings(evaluation, map.request, map.grid, map.outcomes, edges, progress);
  const auto connected = [&](int i, int j) {
    double sum = 0;
    for (const std::size_t k : {map.grid.index(i, j), map.grid.index(i + 1, j), map.grid.index(i, j + 1), map.grid.index(i + 1, j + 1)}) sum += level(map.outcomes[k]);
    return sum >= 0;
  };
  map.feasible = contours(map.grid, kept, edges, crossing, connected);
  map.boundary_tolerance = boundary_tolerance;
  if (map.best) map.margin_lines = margin_lines(map.drawn, map.outcomes, static_cast<double>(map.outcomes[*map.best].margin));
  map.marks = marks(project, map.request, evaluation, options.evaluation.threads, progress);
  return map;
}

bool has_own_map(const Project& project, const Case& variant) {
  const std::optional<MapRequest>& of_base = project.base().analyses.map;
  return variant.analyses.map && (variant.name.empty() || !of_base || !(*variant.analyses.map == *of_base));
}

std::vector<std::string> verdict_words(const DesignMap& map, const MapMark& mark) {
  std::vector<std::string> words;
  if (!mark.judged) return {"not computed: " + mark.failure};
  const JudgedDesign& judged = *mark.judged;
  for (std::size_t r = 0; r < map.rules.size(); ++r) {
    const MapRule& rule = map.rules[r];
    const double value = judged.rules.values[r], at = judged.rules.angular_frequencies[r];
    if (rule.kind == response::DesignRule::Kind::amplitude && value > rule.allowed)
      words.push_back(fmt::format("{} reaches {:.4g} {} {}, allowed {:.4g}", rule.answer, value, rule.unit, std::isinf(at) ? "towards ω = ∞" : fmt::format("at {:.4g} rad/s", at), rule.allowed));
  }
  for (const bool counted : {true, false})
    for (std::size_t c = 0; c < judged.peaks.curves.size(); ++c) {
      const std::string& name = judged.peaks.curves[c].name;
      const bool ruled = std::any_of(map.rules.begin(), map.rules.end(), [&](const MapRule& r) { return r.kind == response::DesignRule::Kind::no_peak && r.answer == name && r.unit == judged.peaks.curves[c].unit; });
      std::string list;
      for (const response::Peak& peak : judged.peaks.list) {
        const double prominence = response::relative_prominence(peak);
        if (!ruled || peak.curve != c || (prominence > map.request.peak_tolerance) != counted) continue;
        list += fmt::format("{}{:.4g} rad/s ({})", list.empty() ? "" : ", ", peak.angular_frequency, std::isinf(prominence) ? "no bound" : fmt::format("{:.3g} %", 100 * prominence));
      }
      if (!list.empty()) words.push_back(fmt::format("{} {} at {}", name, counted ? "peaks" : "rises slightly", list));
    }
  if (judged.governing.kept())
    words.push_back(std::isinf(judged.governing.margin) ? "no rule limits it" : fmt::format("least margin {:.4g}: {}", judged.governing.margin, map.rules[judged.governing.rule].words));
  return words;
}

}  // namespace trivet::study
