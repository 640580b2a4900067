// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "trivet/design/boundary_crossings.h"

namespace trivet::design {

/// Pairs of feasible neighbours between which a natural frequency crosses the whole band of the amplitudes and an
/// infeasible design was found.
struct BandCrossings {
  std::size_t pairs = 0;
  std::array<std::size_t, 2> points{};  ///< along x and y: a grid with this many points has an infeasible design
                                        ///< between every such pair; 0 if no pair lies along that axis
};

/// Finds resonances that both designs of a pair miss because the natural frequency is below the band at one and above
/// it at the other. Bisects the edge until the natural frequency is in the band and evaluates the design there: it
/// violates a rule or, with enough damping, does not.
[[nodiscard]] BandCrossings band_crossings(const MapGrid& grid, const std::vector<DesignOutcome>& outcomes,
                                           const JudgePlaces& judge, const foundation::Progress& progress = {});

}  // namespace trivet::design
