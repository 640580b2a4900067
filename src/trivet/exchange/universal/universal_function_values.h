// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "trivet/exchange/universal/universal_functions.h"

namespace trivet::exchange {

// The values of set 58 in the units of the file: abscissa, if it is uneven, real part and imaginary part of each
// point.

/// Values of a set in text form. nullopt with an error if there are fewer or more than announced, or not numbers.
/// Memory is allocated only after the number of points agrees with the size of the set.
[[nodiscard]] std::optional<std::vector<double>> read_text_values(const UniversalSet& set, const FunctionHead& head,
                                                                  SetProblems& problems);

/// Values of a set in binary form.
struct BinaryValues {
  std::vector<double> numbers;
  std::size_t end = 0;  ///< bytes of the body up to the end of the closing line
};

/// Values of a set in binary form, of either byte order. The end is found by the number of points; if no closing line
/// is there, by the number of bytes in the type line. A warning for each deviation from the standard. nullopt with an
/// error if both numbers disagree with the file, for numbers of a VAX or IBM, and for numbers that are not finite.
[[nodiscard]] std::optional<BinaryValues> read_binary_values(const UniversalSet& set, const FunctionHead& head,
                                                             SetProblems& problems);

}  // namespace trivet::exchange
