// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/numerics/search/max_min.h"

namespace trivet::study {

/// Local maxima of a problem of one variable whose values take long, each by Brent's method between the neighbours of a
/// point that is the best near it. No slopes are needed.
/// @param known  points that were judged, some of them near every maximum worth finding; at least one
/// @param most   so many of the best of them are refined
/// @returns the best point of each, in the order of `known` by rank; without a rise between neighbours the known one
[[nodiscard]] std::vector<numerics::MaxMinPoint> maxima_on_a_line(const numerics::MaxMinProblem& problem,
                                                                  std::vector<numerics::MaxMinPoint> known,
                                                                  std::size_t most,
                                                                  const foundation::Progress& progress);

}  // namespace trivet::study
