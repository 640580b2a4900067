// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/design/drawn_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "trivet/foundation/index.h"

namespace trivet::design {
namespace {

constexpr int most_drawn = 241;  // along an axis: about two pixels apart

std::vector<int> drawn_nodes(int points) {
  const int count = std::min(points, most_drawn);
  assert(count >= 2 && "an axis of a map has two ends");
  std::vector<int> nodes;
  for (int k = 0; k < count; ++k)
    nodes.push_back(static_cast<int>(std::lround(static_cast<double>(k) * (points - 1) / (count - 1))));
  return nodes;
}

/// Linear interpolation between drawn nodes.
double share(double among_nodes, const std::vector<int>& nodes) {
  const double at = among_nodes * static_cast<double>(nodes.size() - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(std::max(at, 0.0)), nodes.size() - 2);
  return (nodes[k] + (at - static_cast<double>(k)) * (nodes[k + 1] - nodes[k])) / nodes.back();
}

}  // namespace

MapPlace DrawnGrid::on_map(const MapPlace& among_nodes) const {
  return {share(among_nodes.x, columns), share(among_nodes.y, rows)};
}

DrawnGrid drawn_grid(const MapGrid& grid) { return {grid, drawn_nodes(grid.nx), drawn_nodes(grid.ny)}; }

}  // namespace trivet::design
