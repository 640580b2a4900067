// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/design/boundary_crossings.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string_view>

namespace trivet::design {
namespace {

constexpr int most_steps = 80;  // bisection alone needs 20 on an axis of two points

/// Interval of one edge that contains the boundary: between a and b, shares of the edge, with the levels there.
struct Bracket {
  double a = 0, b = 1, at_a = 0, at_b = 0;
  double tolerance = 0;
  int steps = 0;

  [[nodiscard]] bool done() const { return std::abs(b - a) <= tolerance || steps >= most_steps; }
  /// Regula falsi with Illinois weights, every third step a bisection; never nearer to an end than half the tolerance.
  [[nodiscard]] double next() const {
    double t = steps % 3 == 2 ? 0.5 * (a + b) : a + (b - a) * at_a / (at_a - at_b);
    const double low = std::min(a, b) + 0.5 * tolerance, high = std::max(a, b) - 0.5 * tolerance;
    return std::clamp(std::isfinite(t) ? t : 0.5 * (a + b), std::min(low, high), std::max(low, high));
  }
  void update(double t, double value) {
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

}  // namespace

MapPlace place_on_edge(const MapGrid& grid, const CrossedEdge& edge, double t) {
  assert(t >= 0 && t <= 1 && "a share of the edge");
  MapPlace p = grid.place(edge.i, edge.j);
  (edge.upwards ? p.y : p.x) += t / ((edge.upwards ? grid.ny : grid.nx) - 1);
  return p;
}

double boundary_level(const DesignOutcome& outcome) {
  constexpr double far = 3;
  if (!outcome.known() || !(outcome.margin > 0)) return -far;
  return std::clamp(std::log(static_cast<double>(outcome.margin)), -far, far);
}

std::vector<double> boundary_crossings(const MapGrid& grid, const std::vector<DesignOutcome>& outcomes,
                                       const std::vector<CrossedEdge>& edges, const JudgePlaces& judge,
                                       const foundation::Progress& progress) {
  std::vector<Bracket> brackets;
  for (const CrossedEdge& e : edges) {
    const std::size_t to = e.upwards ? grid.index(e.i, e.j + 1) : grid.index(e.i + 1, e.j);
    brackets.push_back({0, 1, boundary_level(outcomes[grid.index(e.i, e.j)]), boundary_level(outcomes[to]),
                        boundary_tolerance * ((e.upwards ? grid.ny : grid.nx) - 1), 0});
    assert((brackets.back().at_a >= 0) != (brackets.back().at_b >= 0) && "the boundary crosses the edge");
  }
  std::vector<std::size_t> open(edges.size());
  for (std::size_t e = 0; e < open.size(); ++e) open[e] = e;
  while (true) {
    std::erase_if(open, [&](std::size_t e) { return brackets[e].done(); });
    if (open.empty()) break;
    const foundation::Progress of_boundary = [&](std::string_view, double) {
      foundation::report_progress(progress, "boundary",
                                  1 - static_cast<double>(open.size()) / static_cast<double>(edges.size()));
    };
    std::vector<double> t;
    std::vector<MapPlace> places;
    for (const std::size_t e : open) {
      t.push_back(brackets[e].next());
      places.push_back(place_on_edge(grid, edges[e], t.back()));
    }
    const std::vector<DesignOutcome> found = judge(places, of_boundary);
    assert(found.size() == open.size());
    for (std::size_t k = 0; k < open.size(); ++k) brackets[open[k]].update(t[k], boundary_level(found[k]));
  }
  std::vector<double> crossings;
  for (const Bracket& bracket : brackets) crossings.push_back(0.5 * (bracket.a + bracket.b));
  return crossings;
}

}  // namespace trivet::design
