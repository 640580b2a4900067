// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace trivet::cli {

/// Shows a stream (STDOUT_FILENO, STDERR_FILENO) colours? Only on a terminal, without NO_COLOR and TERM=dumb.
[[nodiscard]] bool has_colours(int stream);

/// The text with the words of verdicts in colour: violations and errors red, warnings and what is not judged yellow,
/// what is met green. Unchanged without `paint`.
[[nodiscard]] std::string painted(std::string_view text, bool paint);

}  // namespace trivet::cli
