// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/design/band_crossings.h"

#include <algorithm>
#include <cassert>
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

}  // namespace trivet::design
