// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/project/text/units.h"

/// Ranges of all numbers in a project file. They are far wider than any machine and keep slips of a power of ten, and
/// squares and products that overflow or underflow, away from the solvers. The stricter range of a key is checked where
/// the key is read.
namespace trivet::project {

/// Largest admissible magnitude of a quantity, SI, and its reason.
struct Largest {
  double magnitude;
  const char* reason;
};
[[nodiscard]] Largest largest(Quantity quantity);

/// Smallest admissible magnitude except 0: products of smaller numbers underflow in double arithmetic.
inline constexpr double smallest_number = 1e-60;

/// The rule that a finite number in SI violates; none if it is admissible.
[[nodiscard]] std::optional<std::string> outside_range(double value, Quantity quantity);

/// The rule that the band from … to [rad/s] violates; none if it is valid: both ends ≥ 0 and different beyond rounding.
[[nodiscard]] std::optional<std::string> wrong_band(double from, double to);

}  // namespace trivet::project
