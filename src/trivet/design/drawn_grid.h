// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "trivet/design/map_contours.h"

namespace trivet::design {

/// The nodes of a grid that pictures show: all, or of a finer grid 241 along an axis, both ends among them.
struct DrawnGrid {
  MapGrid full;
  std::vector<int> columns, rows;  ///< of `full`

  [[nodiscard]] MapGrid nodes() const { return {static_cast<int>(columns.size()), static_cast<int>(rows.size())}; }
  /// Index in `full` of a drawn node.
  [[nodiscard]] std::size_t design(std::size_t node) const {
    return full.index(columns[node % columns.size()], rows[node / columns.size()]);
  }
  /// Where a place on the map of equally distant drawn nodes lies: these are nodes of `full`, not always equally
  /// distant.
  [[nodiscard]] MapPlace on_map(const MapPlace& among_nodes) const;
};

[[nodiscard]] DrawnGrid drawn_grid(const MapGrid& grid);

}  // namespace trivet::design
