// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/design/map_contours.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>
#include <utility>

#include "trivet/foundation/index.h"

namespace trivet::design {
namespace {

/// A piece of a contour within a cell, from one edge of the grid to the next.
struct Segment {
  std::size_t to = 0;
  bool on_frame = false;
};

/// The grid surrounded by one row of outside nodes, so that every region is closed.
class Tracing {
 public:
  Tracing(const MapGrid& grid, const std::function<bool(std::size_t)>& inside) : grid_(grid), inside_(inside) {}

  void place_crossing(const CrossedEdge& edge, double t) {
    MapPlace a = grid_.place(edge.i, edge.j);
    const MapPlace b = edge.upwards ? grid_.place(edge.i, edge.j + 1) : grid_.place(edge.i + 1, edge.j);
    a.x += t * (b.x - a.x);
    a.y += t * (b.y - a.y);
    places_[key(edge.i, edge.j, edge.upwards)] = a;
  }

  /// Adds the cells on both sides of each crossed edge, and those along the frame.
  void walk_cells(const std::vector<CrossedEdge>& edges, const std::function<bool(int, int)>& connected) {
    std::vector<std::pair<int, int>> cells;  // row, column
    for (const CrossedEdge& e : edges) {
      cells.emplace_back(e.j, e.i);
      cells.emplace_back(e.upwards ? e.j : e.j - 1, e.upwards ? e.i - 1 : e.i);
    }
    for (int i = -1; i < grid_.nx; ++i)
      for (const int j : {-1, grid_.ny - 1}) cells.emplace_back(j, i);
    for (int j = 0; j + 1 < grid_.ny; ++j)
      for (const int i : {-1, grid_.nx - 1}) cells.emplace_back(j, i);
    std::ranges::sort(cells);
    cells.erase(std::ranges::unique(cells).begin(), cells.end());
    for (const auto& [j, i] : cells) add_cell(i, j, connected);
  }

  MapContours outline() {
    MapContours result;
    while (!next_.empty()) {
      const std::size_t start = next_.begin()->first;
      MapLine ring;
      std::vector<bool> on_frame;
      std::size_t vertex = start;
      do {
        const auto segment = next_.find(vertex);
        assert(segment != next_.end() && "every region is closed by the nodes outside of the grid");
        ring.push_back(places_.at(vertex));
        on_frame.push_back(segment->second.on_frame);
        vertex = segment->second.to;
        next_.erase(segment);
      } while (vertex != start);
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const MapPlace &a = ring[k], &b = ring[(k + 1) % ring.size()];
        result.area += 0.5 * (a.x * b.y - b.x * a.y);
      }
      add_lines(ring, on_frame, result.lines);
      result.rings.push_back(std::move(ring));
    }
    return result;
  }

 private:
  [[nodiscard]] bool real(int i, int j) const { return i >= 0 && j >= 0 && i < grid_.nx && j < grid_.ny; }
  [[nodiscard]] bool inside(int i, int j) const { return real(i, j) && inside_(grid_.index(i, j)); }
  [[nodiscard]] std::size_t key(int i, int j, bool upwards) const {
    return 2 * (to_size(j + 1) * to_size(grid_.nx + 2) + to_size(i + 1)) + (upwards ? 1 : 0);
  }

  /// The crossing of an edge; if the edge leads out of the grid, its node inside the grid.
  std::size_t vertex(int i, int j, bool upwards) {
    const std::size_t id = key(i, j, upwards);
    const int i2 = i + (upwards ? 0 : 1), j2 = j + (upwards ? 1 : 0);
    if (!real(i, j)) places_[id] = grid_.place(i2, j2);
    else if (!real(i2, j2)) places_[id] = grid_.place(i, j);
    return id;
  }

  /// Corners and edges counter-clockwise: corner c at (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1); edge c from
  /// corner c to the next.
  void add_cell(int i, int j, const std::function<bool(int, int)>& connected) {
    const std::array<bool, 4> corner = {inside(i, j), inside(i + 1, j), inside(i + 1, j + 1), inside(i, j + 1)};
    const auto crossing = [&](int e) { return vertex(i + (e == 1 ? 1 : 0), j + (e == 2 ? 1 : 0), e == 1 || e == 3); };
    std::vector<int> entering, leaving;  // edges at which a turn around the cell enters and leaves the region
    for (int e = 0; e < 4; ++e) {
      const bool from = corner[e], to = corner[(e + 1) % 4];
      if (!from && to) entering.push_back(e);
      if (from && !to) leaving.push_back(e);
    }
    assert(entering.size() == leaving.size() && "a turn around a cell leaves a region as often as it enters it");
    const bool frame = i < 0 || j < 0 || i + 1 >= grid_.nx || j + 1 >= grid_.ny;
    const bool through = entering.size() == 2 && !frame && connected(i, j);
    for (const int out : leaving) {
      // With the region on its left the outline runs from the edge at which a counter-clockwise turn leaves the region
      // to one at which it enters: the edge before if a corner is cut off, the edge after if the two corners are
      // connected.
      int best = entering.front();
      for (const int in : entering) {
        const int back = (out - in + 4) % 4;
        if ((through && back == 3) || (!through && back == 1) || entering.size() == 1) best = in;
      }
      next_[crossing(out)] = {crossing(best), frame};
    }
  }

  static void add_lines(const MapLine& ring, const std::vector<bool>& on_frame, std::vector<MapLine>& lines) {
    const std::size_t n = ring.size();
    std::size_t start = 0;
    while (start < n && !on_frame[start]) ++start;
    if (start == n) {  // no part on the frame
      lines.push_back(ring);
      lines.back().push_back(ring.front());
      return;
    }
    MapLine line;
    for (std::size_t k = 1; k <= n; ++k) {
      const std::size_t at = (start + k) % n;
      if (!on_frame[at]) {
        if (line.empty()) line.push_back(ring[at]);
        line.push_back(ring[(at + 1) % n]);
      } else if (!line.empty()) {
        lines.push_back(std::move(line));
        line.clear();
      }
    }
  }

  const MapGrid& grid_;
  const std::function<bool(std::size_t)>& inside_;
  std::map<std::size_t, MapPlace> places_;
  std::map<std::size_t, Segment> next_;
};

}  // namespace

std::vector<CrossedEdge> crossed_edges(const MapGrid& grid, const std::function<bool(std::size_t)>& inside) {
  std::vector<CrossedEdge> edges;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const bool here = inside(grid.index(i, j));
      if (i + 1 < grid.nx && here != inside(grid.index(i + 1, j))) edges.push_back({i, j, false});
      if (j + 1 < grid.ny && here != inside(grid.index(i, j + 1))) edges.push_back({i, j, true});
    }
  return edges;
}

MapContours contours(const MapGrid& grid, const std::function<bool(std::size_t)>& inside,
                     const std::vector<CrossedEdge>& edges, const std::vector<double>& crossing,
                     const std::function<bool(int, int)>& connected) {
  Tracing tracing(grid, inside);
  assert(crossing.size() == edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) tracing.place_crossing(edges[e], crossing[e]);
  tracing.walk_cells(edges, connected);
  return tracing.outline();
}

}  // namespace trivet::design
