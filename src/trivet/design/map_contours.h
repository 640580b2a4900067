// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "trivet/foundation/index.h"

namespace trivet::design {

/// A place on a map: 0 … 1 along each axis.
struct MapPlace {
  double x = 0, y = 0;
};
using MapLine = std::vector<MapPlace>;

/// Nodes at equal spacing along both axes, row by row.
struct MapGrid {
  int nx = 2, ny = 2;

  [[nodiscard]] std::size_t count() const { return to_size(nx) * to_size(ny); }
  [[nodiscard]] std::size_t index(int i, int j) const { return to_size(j) * to_size(nx) + to_size(i); }
  [[nodiscard]] MapPlace place(int i, int j) const {
    return {static_cast<double>(i) / (nx - 1), static_cast<double>(j) / (ny - 1)};
  }
};

/// An edge of the grid between neighbours, one inside a region and one outside.
struct CrossedEdge {
  int i = 0, j = 0;
  bool upwards = false;  ///< from (i, j) to (i, j + 1), otherwise to (i + 1, j)
};

/// All crossed edges, row by row.
[[nodiscard]] std::vector<CrossedEdge> crossed_edges(const MapGrid& grid,
                                                     const std::function<bool(std::size_t)>& inside);

/// Outline of a region.
struct MapContours {
  std::vector<MapLine> rings;  ///< closed, also along the frame, the region on their left; to be filled even–odd
  std::vector<MapLine> lines;  ///< the parts inside the frame; a closed line ends at its first point
  double area = 0;             ///< of the region, as a share of the map
};

/// Outline by marching squares through the crossings of the edges.
/// @param crossing   position of the outline on each of `crossed_edges`, 0 … 1 along the edge
/// @param connected  are the two diagonally opposite inside corners of a cell connected? By the index of its lower left
/// node
[[nodiscard]] MapContours contours(const MapGrid& grid, const std::function<bool(std::size_t)>& inside,
                                   const std::vector<CrossedEdge>& edges, const std::vector<double>& crossing,
                                   const std::function<bool(int i, int j)>& connected);

}  // namespace trivet::design
