// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>

#include "trivet/exchange/universal/universal_file.h"

/// Units of the numbers in universal files.
namespace trivet::exchange {

enum class UniversalMotion { scalar, translation, rotation };

/// Motion of a direction code of set 58: 0; ±1, ±2, ±3; ±4, ±5, ±6.
[[nodiscard]] UniversalMotion motion_of_direction(int direction);

/// Powers of length, force and temperature in the unit of a quantity, by the table of the standard. `given` are those
/// of the file: they count for quantity general, and for a scalar if they are not zero. nullopt if the quantity is not
/// in the table.
[[nodiscard]] std::optional<UniversalExponents> unit_exponents(UniversalQuantity quantity, UniversalMotion motion,
                                                               const UniversalExponents& given);

/// Number in SI of one unit of the file.
[[nodiscard]] double unit_value(const UniversalUnits& units, const UniversalExponents& exponents);

/// True if all factors are 1.
[[nodiscard]] bool is_si(const UniversalUnits& units);

/// "m/s2", or empty if there is no name.
[[nodiscard]] std::string_view si_unit_label(UniversalQuantity quantity, UniversalMotion motion);

/// A unit that a label names.
struct UniversalLabelUnit {
  double value = 1;    ///< of one unit in SI, or in Hz
  bool turns = false;  ///< of a rotation or a moment
  bool operator==(const UniversalLabelUnit&) const = default;
};

/// Unit that a label names: 9.80665 for "g" and an acceleration. A scalar may be a translation or a rotation.
/// nullopt if the label is not a known one of this quantity and motion.
[[nodiscard]] std::optional<UniversalLabelUnit> unit_of_label(UniversalQuantity quantity, UniversalMotion motion,
                                                              std::string_view label);

}  // namespace trivet::exchange
