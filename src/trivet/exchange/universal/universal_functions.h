// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/exchange/universal/universal_file.h"
#include "trivet/exchange/universal/universal_sets.h"

namespace trivet::exchange {

struct UniversalFunctionSet {
  std::optional<UniversalFunction> function;  ///< none if the set is wrong
  std::size_t end = 0;  ///< of a binary set: bytes of its body with the closing line; 0 if unknown
};

/// Reads set 58, text or binary, and converts it to SI. Errors for records and values that are missing, too many or not
/// finite, and for times and frequencies that do not increase.
[[nodiscard]] UniversalFunctionSet read_universal_function(const UniversalSet& set,
                                                           const std::optional<UniversalUnits>& units,
                                                           SetProblems& problems);

/// Converts abscissa and ordinates to SI by the units of the file (none: it has no set 164), or without them by the
/// labels of the axes; frequencies are in Hz. What the file states is noted in the axes: where both disagree the units
/// are used, and who uses the function decides. Warns if they cannot be converted.
void convert_to_si(UniversalFunction& function, const std::optional<UniversalUnits>& units, int line,
                   SetProblems& problems);

}  // namespace trivet::exchange
