// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/exchange/universal_file.h"

/// Names of the contents of universal files, for messages and keys.
namespace trivet::project {

/// "3:+z" of a node and a direction ±1 … ±6.
[[nodiscard]] std::string point_name(const exchange::UniversalPoint& point);

}  // namespace trivet::project
