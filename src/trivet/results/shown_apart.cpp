// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/shown_apart.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

namespace trivet::results {

std::pair<std::string, std::string> shown_apart(double a, double b, int digits) {
  constexpr double noticeable = 0.01;  // share of their difference
  const auto shown = [&](double x) { return fmt::format("{:.{}g}", x, digits); };
  const auto misses = [&](double x) {
    const std::string text = shown(x);
    double read = 0;
    std::from_chars(text.data(), text.data() + text.size(), read);
    return std::abs(read - x) > noticeable * std::abs(a - b);
  };
  while (a != b && digits < std::numeric_limits<double>::max_digits10 && (misses(a) || misses(b))) ++digits;
  return {shown(a), shown(b)};
}

}  // namespace trivet::results
