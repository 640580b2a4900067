// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/format/distinct_texts.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

namespace trivet::results {

std::pair<std::string, std::string> distinct_texts(double a, double b, int digits) {
  constexpr double noticeable = 0.01;  // share of their difference
  const auto rounded = [&](double x) { return fmt::format("{:.{}g}", x, digits); };
  const auto misses = [&](double x) {
    const std::string text = rounded(x);
    double read = 0;
    std::from_chars(text.data(), text.data() + text.size(), read);
    return std::abs(read - x) > noticeable * std::abs(a - b);
  };
  while (a != b && digits < std::numeric_limits<double>::max_digits10 && (misses(a) || misses(b))) ++digits;
  return {rounded(a), rounded(b)};
}

}  // namespace trivet::results
