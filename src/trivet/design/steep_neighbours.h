// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/design/design_outcome.h"
#include "trivet/design/map_contours.h"

namespace trivet::design {

/// Pairs of neighbours that limits on amplitudes govern, with margins that differ more than tenfold: a resonance may
/// lie between them and break a rule. The margin of a no-peak rule changes as much where a peak comes up, with no
/// resonance between.
[[nodiscard]] std::size_t steep_neighbours(const MapGrid& grid, const std::vector<MapRule>& rules,
                                           const std::vector<DesignOutcome>& outcomes);

}  // namespace trivet::design
