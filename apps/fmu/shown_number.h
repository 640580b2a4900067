// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace trivet::fmu {

/// A number for a message, with up to 12 digits.
[[nodiscard]] std::string shown(double number);

}  // namespace trivet::fmu
