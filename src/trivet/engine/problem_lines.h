// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/engine/session.h"
#include "trivet/foundation/problems.h"

namespace trivet::engine {

/// Problems as the command line prints them, and below each its line of the file with carets under the value. A list of
/// more than ten problems is without lines.
/// @param source  the project; lines of its text, if it has one, in place of those of a file
[[nodiscard]] std::string message_list_with_lines(const foundation::Problems& problems, const Source& source);

}  // namespace trivet::engine
