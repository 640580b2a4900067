// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "trivet/foundation/problems.h"

namespace trivet::foundation {

/// Most problems in one list: one mistake can affect thousands of lines, and the first hundred show it.
inline constexpr std::size_t most_messages = 100;

/// Problems to list: all, or the first `most_messages`, errors before warnings.
[[nodiscard]] Problems listed(const Problems& problems);

/// "… and 11197 more (11000 errors, 197 warnings); correct what is listed and check again"; empty if all are listed.
[[nodiscard]] std::string rest_of_list(const Problems& problems);

/// One line for each listed problem, and one with the number of the others.
[[nodiscard]] std::string message_list(const Problems& problems);

/// Notes "A: words" and "B: words" of several things as one, "A, B: words", at the place of the first.
[[nodiscard]] std::vector<std::string> grouped(const std::vector<std::string>& notes);

}  // namespace trivet::foundation
