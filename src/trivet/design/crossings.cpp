// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/design/crossings.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string_view>

#include "trivet/foundation/index.h"

namespace trivet::design {

namespace {

constexpr int most_halvings = 20;  // a strip thinner than a millionth of a step is ignored

/// One natural frequency, counted from the lowest, that is below the band at `below` and above it at `above` (shares of
/// the edge).
struct BandCrossing {
  CrossedEdge edge;
  int mode = 0;
  double below = 0, above = 1;
  int halvings = 0;
  bool open = true, violates = false;

  void update(const DesignOutcome& outcome) {
    const double middle = 0.5 * (below + above);
    ++halvings;
    violates = outcome.known() && !outcome.feasible();
    open = outcome.feasible() && halvings < most_halvings;
    if (outcome.modes_below >= mode) below = middle;
    else if (outcome.modes_up_to() < mode) above = middle;
    else open = false;
  }
};

void add_band_crossings(const CrossedEdge& edge, const DesignOutcome& from, const DesignOutcome& to,
                        std::vector<BandCrossing>& crossings) {
  if (!from.feasible() || !to.feasible()) return;
  for (int mode = to.modes_up_to() + 1; mode <= from.modes_below; ++mode) crossings.push_back({edge, mode, 0, 1});
  for (int mode = from.modes_up_to() + 1; mode <= to.modes_below; ++mode) crossings.push_back({edge, mode, 1, 0});
}

std::vector<BandCrossing> band_crossings_of(const MapGrid& grid, const std::vector<DesignOutcome>& outcomes) {
  std::vector<BandCrossing> crossings;
  assert(outcomes.size() == grid.count());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const DesignOutcome& here = outcomes[grid.index(i, j)];
      if (i + 1 < grid.nx) add_band_crossings({i, j, false}, here, outcomes[grid.index(i + 1, j)], crossings);
      if (j + 1 < grid.ny) add_band_crossings({i, j, true}, here, outcomes[grid.index(i, j + 1)], crossings);
    }
  return crossings;
}

}  // namespace

BandCrossings band_crossings(const MapGrid& grid, const std::vector<DesignOutcome>& outcomes, const JudgePlaces& judge,
                             const foundation::Progress& progress) {
  std::vector<BandCrossing> crossings = band_crossings_of(grid, outcomes);
  for (int step = 0; step < most_halvings; ++step) {
    std::vector<MapPlace> places;
    for (const BandCrossing& p : crossings)
      if (p.open) places.push_back(place_on_edge(grid, p.edge, 0.5 * (p.below + p.above)));
    if (places.empty()) break;
    const std::vector<DesignOutcome> found = judge(places, [&](std::string_view, double) {
      foundation::report_progress(progress, "between designs", static_cast<double>(step) / most_halvings);
    });
    std::size_t next = 0;
    for (BandCrossing& p : crossings)
      if (p.open) p.update(found[next++]);
    assert(next == found.size() && "one outcome for each place between two designs");
  }
  BandCrossings result;
  const CrossedEdge* last = nullptr;
  for (const BandCrossing& p : crossings) {
    if (!p.violates) continue;
    const bool same = last && last->i == p.edge.i && last->j == p.edge.j &&
        last->upwards == p.edge.upwards;  // several modes of one pair
    result.pairs += !same;
    last = &p.edge;
    const auto steps = to_size((p.edge.upwards ? grid.ny : grid.nx) - 1);
    std::size_t& points = result.points[p.edge.upwards ? 1 : 0];
    points = std::max(points, (steps << p.halvings) + 1);
  }
  return result;
}

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
