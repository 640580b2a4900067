// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "trivet/exchange/universal/universal_function_values.h"
#include "trivet/exchange/universal/universal_records.h"

namespace trivet::exchange {
namespace {

constexpr std::array single_widths{13, 13, 13, 13, 13, 13};
constexpr std::array even_double_widths{20, 20, 20, 20};
constexpr std::array uneven_real_widths{13, 20, 13, 20};
constexpr std::array uneven_complex_widths{13, 20, 20};
/// A digit and a blank.
constexpr std::size_t least_bytes_per_number = 2;

FieldWidths widths_of(const UniversalFunction& function) {
  if (function.precision == UniversalPrecision::single_precision) return single_widths;
  if (is_even(function)) return even_double_widths;
  if (function.is_complex) return uneven_complex_widths;
  return uneven_real_widths;
}

std::string cut_off_or(const UniversalSet& set, const char* otherwise) {
  return set.closed ? otherwise : "was the file cut off?";
}

/// Rejects what follows the announced values, except for zeros that fill the last line.
bool nothing_follows(std::vector<double>& numbers, std::size_t wanted, Lines& lines, int first_line,
                     SetProblems& problems) {
  const auto surplus = numbers.begin() + static_cast<std::ptrdiff_t>(wanted);
  const int line = first_line + lines.number();
  const bool zeros = std::all_of(surplus, numbers.end(), [](double value) { return value == 0; });
  if (numbers.size() > wanted && zeros)
    problems.warning(line, "last line", fmt::format("{} zeros too many", numbers.size() - wanted),
                     "a set has as many numbers as announced", "ignored");
  bool more = numbers.size() > wanted && !zeros;
  while (!more && lines.next()) more = !trimmed(lines.line()).empty();
  numbers.resize(wanted);
  if (more)
    problems.error(first_line + lines.number(), "values", "more than announced",
                   fmt::format("{} numbers are announced", wanted), "correct the number of points");
  return !more;
}

}  // namespace

std::optional<std::vector<double>> read_text_values(const UniversalSet& set, const FunctionHead& head,
                                                    SetProblems& problems) {
  const std::string_view data = set.body.substr(head.values_at);
  const std::size_t per_point = numbers_per_point(head.function);
  if (head.points > (data.size() + 1) / (least_bytes_per_number * per_point)) {
    problems.error(head.points_line, "points", fmt::format("{} announced", head.points),
                   fmt::format("the set has only {} bytes of values", data.size()),
                   cut_off_or(set, "was the set cut off?"));
    return std::nullopt;
  }
  const std::size_t wanted = head.points * per_point;
  const FieldWidths widths = widths_of(head.function);
  std::vector<double> numbers;
  numbers.reserve(wanted + widths.size());
  Lines lines(data);
  while (numbers.size() < wanted && lines.next()) {
    if (trimmed(lines.line()).empty()) continue;
    const auto line = values_of_line(lines.line(), head.last_line + lines.number(), widths, problems);
    if (!line) return std::nullopt;
    numbers.insert(numbers.end(), line->begin(), line->end());
  }
  if (numbers.size() < wanted) {
    problems.error(head.last_line + lines.number(), "values", fmt::format("{} numbers", numbers.size()),
                   fmt::format("{} points with {} numbers each are announced", head.points, per_point),
                   cut_off_or(set, "was the set cut off, or is the number of points wrong?"));
    return std::nullopt;
  }
  if (!nothing_follows(numbers, wanted, lines, head.last_line, problems)) return std::nullopt;
  return numbers;
}

}  // namespace trivet::exchange
