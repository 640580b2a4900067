// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/design/design_outcome.h"
#include "trivet/design/map_contours.h"

namespace trivet::design {

/// Number of pairs of neighbours that are governed by limits on amplitudes and have margins that differ more than
/// tenfold: a resonance between them may violate a rule. The margin of a no-peak rule changes as much when a peak
/// appears, without a resonance between.
[[nodiscard]] std::size_t steep_neighbours(const MapGrid& grid, const std::vector<MapRule>& rules,
                                           const std::vector<DesignOutcome>& outcomes);

}  // namespace trivet::design
