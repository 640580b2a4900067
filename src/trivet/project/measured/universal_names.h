// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/exchange/universal/universal_file.h"

/// Names of the contents of universal files, for messages and keys.
namespace trivet::project {

/// "3:+z" of a node and a direction ±1 … ±6.
[[nodiscard]] std::string point_name(const exchange::UniversalPoint& point);

/// "time response (type 1)", with the type of the abscissa if it is not a frequency.
[[nodiscard]] std::string universal_kind(const exchange::UniversalFunction& function);

/// "2 × time response (type 1), 1 × coherence (type 6)"; "no functions".
[[nodiscard]] std::string universal_kinds(const std::vector<exchange::UniversalFunction>& functions);

}  // namespace trivet::project
