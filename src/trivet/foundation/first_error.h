// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/foundation/problems.h"

namespace trivet::foundation {

/// The first problem that is no warning; nullptr if there is none.
[[nodiscard]] const Problem* first_error(const Problems& problems);

/// The same of problems that have an error.
[[nodiscard]] const Problem& error_of(const Problems& problems);

/// The message of the first error, "machine.toml:7: error: bodies.m.mass: …"; empty if there is none.
[[nodiscard]] std::string first_message(const Problems& problems);

/// Path, finding and rule of an error that exists, without the line of the file and the remedy, for designs that a
/// search tries.
[[nodiscard]] std::string first_reason(const Problems& problems);

/// @throws InvalidInput with the message of the first error, if there is one
void refuse_errors(const Problems& problems);

}  // namespace trivet::foundation
