// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/exchange/universal/universal_file.h"
#include "trivet/exchange/universal/universal_sets.h"

/// The sets that describe a universal file: its header and its units.
namespace trivet::exchange {

/// Reads set 151. Lines that are missing are empty texts.
[[nodiscard]] UniversalHeader read_universal_header(const UniversalSet& set, SetProblems& problems);

/// Reads set 164. nullopt with an error if a factor is missing or not > 0; a warning if factors and code disagree.
[[nodiscard]] std::optional<UniversalUnits> read_universal_units(const UniversalSet& set, SetProblems& problems);

/// Checks the end of a set whose content seems complete: a warning if the closing line is missing, and an error if the
/// file also ends within a line, because its last number may be cut.
void check_end(const UniversalSet& set, SetProblems& problems);

}  // namespace trivet::exchange
