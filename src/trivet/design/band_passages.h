// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "trivet/design/boundary_crossings.h"

namespace trivet::design {

/// Kept neighbours between which a natural frequency passes over the whole band of the amplitudes, where a design
/// breaks a rule.
struct BandPassages {
  std::size_t pairs = 0;
  std::array<std::size_t, 2> points{};  ///< along x and y: a grid of so many has a broken design between every such
                                        ///< pair; 0 without one along that axis
};

/// Where a resonance stands in the band of one of the two, its height was seen; where it passes over the band from one
/// to the next, neither knows of it. Halves the way between these until the natural frequency stands in the band, and
/// asks the design there: it breaks a rule or, with enough damping, does not.
[[nodiscard]] BandPassages band_passages(const MapGrid& grid, const std::vector<DesignOutcome>& outcomes,
                                         const JudgePlaces& judge, const foundation::Progress& progress = {});

}  // namespace trivet::design
