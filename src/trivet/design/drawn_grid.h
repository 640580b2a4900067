// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "trivet/design/design_outcome.h"
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

/// Number of pairs of neighbours that are governed by limits on amplitudes and have margins that differ more than
/// tenfold: a resonance between them may violate a rule. The margin of a no-peak rule changes as much when a peak
/// appears, without a resonance between.
[[nodiscard]] std::size_t steep_neighbours(const MapGrid& grid, const std::vector<MapRule>& rules,
                                           const std::vector<DesignOutcome>& outcomes);

struct BestDesign {
  std::size_t design = 0;
  std::size_t without_bound = 0;  ///< designs that no rule limits; if there are any, the best is one of these
  std::size_t equals = 1;         ///< designs with the same margin, to a millionth
};

/// The design with the largest margin. Among equals (also those that no rule limits) it is the one farthest, in shares
/// of the axes, from every other design and from the frame; on fine grids only the drawn designs are candidates. Empty
/// if no design is known.
[[nodiscard]] std::optional<BestDesign> best_design(const DrawnGrid& grid, const std::vector<DesignOutcome>& outcomes);

}  // namespace trivet::design
