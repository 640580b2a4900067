// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>

namespace trivet::results {

/// Two numbers in `digits` significant digits, or in as many more as show how far they are apart.
[[nodiscard]] std::pair<std::string, std::string> shown_apart(double a, double b, int digits);

}  // namespace trivet::results
