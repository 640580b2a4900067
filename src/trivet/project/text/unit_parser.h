// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "trivet/foundation/problems.h"
#include "trivet/project/text/unit_table.h"

namespace trivet::project {

/// A product of units with integer exponents: "kg m2/s", "N·m/rad", "(m/s^2)^2/Hz", "lbf-in", "1/s". Products and
/// quotients are read from left to right: "N/mm s" is (N/mm)·s. The offset of a temperature is that of a unit alone.
/// @returns the word that is no unit, or the text without a word to blame
[[nodiscard]] tl::expected<UnitValue, std::string> parsed_unit(std::string_view text);

}  // namespace trivet::project
