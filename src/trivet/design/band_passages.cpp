// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/design/band_passages.h"

#include <algorithm>
#include <string_view>

namespace trivet::design {
namespace {

constexpr int most_halvings = 20;  // a strip thinner than a millionth of a step is ignored

/// One natural frequency, counted from the lowest, that is below the band at `below` and above it at `above` (shares of
/// the edge).
struct Passage {
  CrossedEdge edge;
  int mode = 0;
  double below = 0, above = 1;
  int halvings = 0;
  bool open = true, breaks = false;

  void see(const DesignOutcome& outcome) {
    const double middle = 0.5 * (below + above);
    ++halvings;
    breaks = outcome.known() && !outcome.kept();
    open = outcome.kept() && halvings < most_halvings;
    if (outcome.modes_below >= mode) below = middle;
    else if (outcome.modes_up_to() < mode) above = middle;
    else open = false;
  }
};

void add_passages(const CrossedEdge& edge, const DesignOutcome& from, const DesignOutcome& to,
                  std::vector<Passage>& passages) {
  if (!from.kept() || !to.kept()) return;
  for (int mode = to.modes_up_to() + 1; mode <= from.modes_below; ++mode) passages.push_back({edge, mode, 0, 1});
  for (int mode = from.modes_up_to() + 1; mode <= to.modes_below; ++mode) passages.push_back({edge, mode, 1, 0});
}

std::vector<Passage> passages_of(const MapGrid& grid, const std::vector<DesignOutcome>& outcomes) {
  std::vector<Passage> passages;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const DesignOutcome& here = outcomes[grid.index(i, j)];
      if (i + 1 < grid.nx) add_passages({i, j, false}, here, outcomes[grid.index(i + 1, j)], passages);
      if (j + 1 < grid.ny) add_passages({i, j, true}, here, outcomes[grid.index(i, j + 1)], passages);
    }
  return passages;
}

}  // namespace

BandPassages band_passages(const MapGrid& grid, const std::vector<DesignOutcome>& outcomes, const JudgePlaces& judge,
                           const foundation::Progress& progress) {
  std::vector<Passage> passages = passages_of(grid, outcomes);
  for (int step = 0; step < most_halvings; ++step) {
    std::vector<MapPlace> places;
    for (const Passage& p : passages)
      if (p.open) places.push_back(place_on_edge(grid, p.edge, 0.5 * (p.below + p.above)));
    if (places.empty()) break;
    const std::vector<DesignOutcome> found = judge(places, [&](std::string_view, double) {
      foundation::report_progress(progress, "between designs", static_cast<double>(step) / most_halvings);
    });
    std::size_t next = 0;
    for (Passage& p : passages)
      if (p.open) p.see(found[next++]);
  }
  BandPassages result;
  const CrossedEdge* last = nullptr;
  for (const Passage& p : passages) {
    if (!p.breaks) continue;
    const bool same = last && last->i == p.edge.i && last->j == p.edge.j &&
        last->upwards == p.edge.upwards;  // several modes of one pair
    result.pairs += !same;
    last = &p.edge;
    const auto steps = static_cast<std::size_t>((p.edge.upwards ? grid.ny : grid.nx) - 1);
    std::size_t& points = result.points[p.edge.upwards ? 1 : 0];
    points = std::max(points, (steps << p.halvings) + 1);
  }
  return result;
}

}  // namespace trivet::design
