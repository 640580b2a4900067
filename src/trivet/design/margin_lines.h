// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/design/design_outcome.h"
#include "trivet/design/drawn_grid.h"

namespace trivet::design {

/// A line of equal margin.
struct MarginLine {
  double margin = 1;
  std::vector<MapLine> lines;
};

/// Lines of a few round margins between 1 and `largest` (below `largest` if that is below 1), straight between drawn
/// designs, for pictures. A line ends where the margin of a neighbour is unbounded, because its position is then
/// unknown, and where two lines, or a line and the boundary, pass between the same two designs.
[[nodiscard]] std::vector<MarginLine> margin_lines(const DrawnGrid& grid, const std::vector<DesignOutcome>& outcomes,
                                                   double largest);

}  // namespace trivet::design
