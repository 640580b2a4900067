// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>

namespace trivet::results {

/// Two numbers with `digits` significant digits, or with as many more as needed to show their difference.
[[nodiscard]] std::pair<std::string, std::string> distinct_texts(double a, double b, int digits);

}  // namespace trivet::results
