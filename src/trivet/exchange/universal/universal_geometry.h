// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/exchange/universal/universal_file.h"
#include "trivet/exchange/universal/universal_sets.h"

/// The sets with the geometry of a universal file: points and wire frame.
namespace trivet::exchange {

/// Reads set 15 and converts positions to m. An error for each line that is not a node. Coordinate systems are applied
/// later: universal_systems.h.
[[nodiscard]] std::vector<UniversalNode> read_universal_nodes(const UniversalSet& set, const UniversalUnits& units,
                                                              SetProblems& problems);

/// The same of set 2411: nodes in double precision, two lines each.
[[nodiscard]] std::vector<UniversalNode> read_universal_part_nodes(const UniversalSet& set, const UniversalUnits& units,
                                                                   SetProblems& problems);

/// Reads set 82. nullopt with an error if it has fewer nodes than announced; a warning if it has more.
[[nodiscard]] std::optional<UniversalLine> read_universal_line(const UniversalSet& set, SetProblems& problems);

}  // namespace trivet::exchange
