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

/// Lines of a few round margins between 1 and `largest`, or where that is below 1 of some below it, straight between
/// drawn designs, for pictures. They end where a neighbour's margin has no bound, for nothing says where they run, and
/// where two of them, or one and the boundary, pass between the same two designs: there they lie closer than these.
[[nodiscard]] std::vector<MarginLine> margin_lines(const DrawnGrid& grid, const std::vector<DesignOutcome>& outcomes,
                                                   double largest);

}  // namespace trivet::design
