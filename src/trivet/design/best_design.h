// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "trivet/design/design_outcome.h"
#include "trivet/design/drawn_grid.h"

namespace trivet::design {

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
