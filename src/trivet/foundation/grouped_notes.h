// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace trivet::foundation {

/// Notes "A: words" and "B: words" of several things as one, "A, B: words", at the place of the first.
[[nodiscard]] std::vector<std::string> grouped(const std::vector<std::string>& notes);

}  // namespace trivet::foundation
