// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "trivet/design/map_contours.h"

namespace trivet::design {

/// The nodes of a grid that pictures show: all, or at most 241 along an axis, both ends included.
struct DrawnGrid {
  MapGrid full;
  std::vector<int> columns, rows;  ///< indices in `full`

  [[nodiscard]] MapGrid nodes() const { return {static_cast<int>(columns.size()), static_cast<int>(rows.size())}; }
  /// Index in `full` of a drawn node.
  [[nodiscard]] std::size_t design(std::size_t node) const {
    return full.index(columns[node % columns.size()], rows[node / columns.size()]);
  }
  /// Converts a place between drawn nodes, assumed equally spaced, to its place on the map, where they are not always
  /// equally spaced.
  [[nodiscard]] MapPlace on_map(const MapPlace& among_nodes) const;
};

[[nodiscard]] DrawnGrid drawn_grid(const MapGrid& grid);

}  // namespace trivet::design
