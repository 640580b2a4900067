// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/project/text/units.h"

/// Which numbers a project file may hold at all. The ranges are far wider than any machine: they keep slips of a power
/// of ten, and squares and products that overflow or vanish, away from the solvers. What a single key admits is
/// stricter and is checked where the key is read.
namespace trivet::project {

/// The largest magnitude that a quantity may have, SI, and why.
struct Largest {
  double magnitude;
  const char* reason;
};
[[nodiscard]] Largest largest(Quantity quantity);

/// Smaller numbers are not told apart from 0, for their products vanish in double arithmetic.
inline constexpr double smallest_number = 1e-60;

/// The rule that a finite number in SI breaks; none if it is admitted.
[[nodiscard]] std::optional<std::string> outside_range(double value, Quantity quantity);

/// The rule that the band from … to breaks [rad/s]; none if it is one. Both ends are ≥ 0, and are different numbers
/// beyond rounding.
[[nodiscard]] std::optional<std::string> wrong_band(double from, double to);

}  // namespace trivet::project
