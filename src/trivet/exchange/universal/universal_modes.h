// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/exchange/universal/universal_file.h"
#include "trivet/exchange/universal/universal_sets.h"

namespace trivet::exchange {

struct UniversalModeSet {
  std::optional<UniversalMode> mode;      ///< none if the set is wrong, or not a mode
  std::optional<UniversalMode> response;  ///< motions at one frequency of a frequency response, in units of the file
  std::string other_content;              ///< "analysis type 5" if the set is neither
};

/// Reads set 55 if it is a normal or complex mode with translations or with translations and rotations, and converts it
/// to SI. Errors for records that are incomplete or not numbers.
[[nodiscard]] UniversalModeSet read_universal_mode(const UniversalSet& set, const UniversalUnits& units,
                                                   SetProblems& problems);

/// The same of set 2414 with results at nodes, as Simcenter, NX and other finite element programs write them.
[[nodiscard]] UniversalModeSet read_universal_analysis_mode(const UniversalSet& set, const UniversalUnits& units,
                                                            SetProblems& problems);

/// Number of elements of set 2412.
[[nodiscard]] int count_universal_elements(const UniversalSet& set);

}  // namespace trivet::exchange
