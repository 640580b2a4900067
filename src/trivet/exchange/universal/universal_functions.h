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

/// Records 1 to 11 of set 58, before its values.
struct FunctionHead {
  UniversalFunction function;  ///< without its values
  std::size_t points = 0;      ///< announced, ≥ 1; not yet compared with the size of the file
  std::size_t values_at = 0;   ///< bytes of the body before the values
  int last_line = 0;           ///< number of the last line of the head
  int points_line = 0;         ///< number of the line with the number of points
};

[[nodiscard]] inline bool is_even(const UniversalFunction& function) {
  return std::holds_alternative<EvenAbscissa>(function.abscissa);
}

/// Numbers of the file per point: real or complex value, and the abscissa if it is uneven.
[[nodiscard]] inline std::size_t numbers_per_point(const UniversalFunction& function) {
  return (function.is_complex ? 2 : 1) + (is_even(function) ? 0 : 1);
}

/// Reads the head of set 58 in the units of the file. nullopt with an error if a record is missing or has no sense.
[[nodiscard]] std::optional<FunctionHead> read_function_head(const UniversalSet& set, SetProblems& problems);

}  // namespace trivet::exchange
