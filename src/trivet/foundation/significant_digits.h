// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace trivet::foundation {

/// So many significant digits, or all of them before the point: "2.85", "12000".
[[nodiscard]] std::string significant(double value, int digits = 4);

/// An SI number with its prefix (unit_prefix.h) and more digits than results have, for numbers that a user wrote.
[[nodiscard]] std::string prefixed_exactly(double value, const std::string& unit, int digits);

/// Two SI numbers with the prefix of the larger one: "0.5 … 1.2 kN".
[[nodiscard]] std::string prefixed_range(double from, double to, const std::string& unit);

}  // namespace trivet::foundation
