// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/exchange/universal/universal_file.h"
#include "trivet/foundation/problems.h"

namespace trivet::project {

// Names of the contents of universal files, for messages and keys.

/// "3:+z" of a node and a direction ±1 … ±6.
[[nodiscard]] std::string point_name(const exchange::UniversalPoint& point);

/// "time response (type 1)", with the type of the abscissa if it is not a frequency.
[[nodiscard]] std::string universal_kind(const exchange::UniversalFunction& function);

/// "2 × time response (type 1), 1 × coherence (type 6)"; "no functions".
[[nodiscard]] std::string universal_kinds(const std::vector<exchange::UniversalFunction>& functions);

/// True if the abscissa is a frequency, or of unknown quantity.
[[nodiscard]] bool may_be_over_frequency(const exchange::UniversalFunction& function);

/// True if two lists of frequencies agree to the six digits that a universal file in text form has.
[[nodiscard]] bool same_frequencies(const std::vector<double>& one, const std::vector<double>& other);

/// Problems of functions over frequency [Hz], each with the line of its set: values that do not increase; a quantity
/// that is not known, as a warning if the label of the unit does not say Hz, and an error if it says something else.
/// @param source  name of the file
[[nodiscard]] foundation::Problems judge_abscissas(const std::vector<const exchange::UniversalFunction*>& functions,
                                                   const std::string& source);

}  // namespace trivet::project
