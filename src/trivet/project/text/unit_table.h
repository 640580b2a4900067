// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace trivet::project {

/// Exponents of metre, kilogram, second, radian, joule, kelvin and ampere. Angle and energy are dimensions of their
/// own: a number is no angle, and an energy no moment.
using Dimension = std::array<int, 7>;

/// A unit is mantissa · 10^ten of the units of its dimension; an exponent keeps "mm" the nearest number to 1/1000. A
/// temperature in it is above absolute zero by `offset` [K] more than its number says.
struct UnitValue {
  double mantissa = 1;
  int ten = 0;
  Dimension dimension{};
  double offset = 0;
};

/// A unit by its name or symbol, with an SI prefix before a unit that is used with prefixes: "kN", "millimetres".
[[nodiscard]] std::optional<UnitValue> unit_of_word(std::string_view word);

/// True for a prefix before a unit that is not used with prefixes: "kft", "mlb".
[[nodiscard]] bool has_odd_prefix(std::string_view word);

}  // namespace trivet::project
