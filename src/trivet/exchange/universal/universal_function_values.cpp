// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/universal/universal_function_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "trivet/exchange/universal/universal_sets.h"

namespace trivet::exchange {

namespace {

constexpr std::size_t blanks_before_delimiter = 4;
constexpr int ieee = 2;

/// Fields of the type line after "58b".
struct BinaryForm {
  bool big_endian = false;
  std::size_t stated_bytes = 0;
};

/// Sizes of the numbers of a point [bytes].
struct PointLayout {
  std::size_t abscissa = 0;  ///< 0 if the abscissa is even
  std::size_t value = 4;     ///< of one real number
  std::size_t reals = 1;     ///< 2 for complex values
  [[nodiscard]] std::size_t bytes() const { return abscissa + reals * value; }
};

struct BinaryBlock {
  PointLayout layout;
  std::size_t points = 0;
  std::size_t closing_bytes = 0;  ///< of the closing line after the numbers
  bool closed = true;
};

std::size_t field_or_zero(const std::vector<std::string_view>& parts, std::size_t i) {
  std::size_t value = 0;
  if (i < parts.size()) std::from_chars(parts[i].data(), parts[i].data() + parts[i].size(), value);
  return value;
}

std::optional<BinaryForm> binary_form(const UniversalSet& set, SetProblems& problems) {
  const auto parts = blank_separated(set.type_line);
  const std::size_t order = field_or_zero(parts, 1), format = field_or_zero(parts, 2), lines = field_or_zero(parts, 3);
  if (parts.front().ends_with('B'))
    problems.warning(set.line, "type", in_quotes(parts.front()), "a binary set begins with 58b", "read as 58b");
  if (format != ieee) {
    problems.error(set.line, "number format",
                   format == 1       ? std::string("numbers of a VAX (1)")
                       : format == 3 ? std::string("numbers of an IBM mainframe (3)")
                                     : in_quotes(set.type_line),
                   "numbers of IEEE 754 (2) are read", "export the file again as text (set 58) or with IEEE numbers");
    return std::nullopt;
  }
  if (order != 1 && order != 2) {
    problems.error(set.line, "byte order", in_quotes(set.type_line), "1 is little-endian, 2 is big-endian",
                   "correct the line");
    return std::nullopt;
  }
  if (lines != 11)
    problems.warning(set.line, "head", fmt::format("{} lines are stated", lines), "it has 11 lines", "read as 11");
  return BinaryForm{order == 2, field_or_zero(parts, 4)};
}

/// The values of a set and the line end of its head.
struct BinaryData {
  std::string_view bytes;
  std::string_view line_end;
};

/// The line end with which `bytes` begin; empty if there is none.
std::string_view first_line_end(std::string_view bytes) {
  for (const std::string_view end : {"\r\n", "\n"})
    if (bytes.starts_with(end)) return end;
  return {};
}

/// Bytes of the line with only -1 at the beginning of `bytes`, perhaps after a line end; 0 if there is no such line.
/// Without a line end before it, -1 must be in columns 5 and 6, and a line feed alone before it must also end this
/// line: otherwise a lost byte of the values would not be noticed.
std::size_t closing_line(std::string_view bytes, std::string_view line_end) {
  const std::string_view before = first_line_end(bytes);
  const std::size_t begin = before.size();
  const std::size_t minus = bytes.find_first_not_of(' ', begin);
  if (minus == std::string_view::npos || !bytes.substr(minus).starts_with("-1")) return 0;
  if (begin == 0 && minus != blanks_before_delimiter) return 0;
  const std::size_t end = bytes.find_first_not_of(" \t\r", minus + 2);
  if (end == std::string_view::npos) return before.size() != 1 || before == line_end ? bytes.size() : 0;
  if (bytes[end] != '\n') return 0;
  return before.size() != 1 || bytes[end - 1] != '\r' ? end + 1 : 0;
}

bool only_line_ends(std::string_view bytes) { return bytes.find_first_not_of("\r\n") == std::string_view::npos; }

/// The block if a closing line follows this number of points, or the end of the file if `end_closes`.
std::optional<BinaryBlock> block_with(const BinaryData& data, const PointLayout& layout, std::size_t points,
                                      bool end_closes) {
  if (points == 0 || points > data.bytes.size() / layout.bytes()) return std::nullopt;
  const std::string_view rest = data.bytes.substr(points * layout.bytes());
  const std::size_t closing = closing_line(rest, data.line_end);
  if (closing > 0) return BinaryBlock{layout, points, closing, true};
  if (end_closes && only_line_ends(rest)) return BinaryBlock{layout, points, rest.size(), false};
  return std::nullopt;
}

/// The abscissa of the standard has single precision, but some programs write it with double precision.
std::vector<PointLayout> possible_layouts(const UniversalFunction& function) {
  const std::size_t value = function.precision == UniversalPrecision::single_precision ? 4 : 8;
  const std::size_t reals = function.is_complex ? 2 : 1;
  if (is_even(function)) return {{0, value, reals}};
  if (value == 4) return {{4, value, reals}};
  return {{4, value, reals}, {8, value, reals}};
}

/// The block of numbers, found by the number of points or else by the stated number of bytes.
std::optional<BinaryBlock> find_block(const BinaryData& data, const FunctionHead& head, std::size_t stated_bytes) {
  const auto layouts = possible_layouts(head.function);
  for (const bool end_closes : {false, true}) {
    for (const PointLayout& layout : layouts)
      if (const auto block = block_with(data, layout, head.points, end_closes)) return block;
    for (const PointLayout& layout : layouts)
      if (stated_bytes % layout.bytes() == 0)
        if (const auto block = block_with(data, layout, stated_bytes / layout.bytes(), end_closes)) return block;
  }
  return std::nullopt;
}

void report_deviations(const UniversalSet& set, const FunctionHead& head, const BinaryBlock& block,
                       std::size_t stated_bytes, std::string_view after, SetProblems& problems) {
  const std::size_t bytes = block.points * block.layout.bytes();
  if (block.points != head.points)
    problems.warning(head.points_line, "points", fmt::format("{} announced", head.points),
                     fmt::format("the set has {} bytes of values, as stated in its first line", bytes),
                     fmt::format("read as {} points", block.points));
  if (stated_bytes != bytes)
    problems.warning(set.line, "bytes", fmt::format("{} stated", stated_bytes),
                     fmt::format("{} points have {} bytes", block.points, bytes), "the number of points is used");
  if (block.layout.abscissa == 8)
    problems.warning(set.line, "abscissa", "in double precision", "by the standard it has single precision",
                     "read with double precision, which fits the size of the set");
  if (!block.closed)
    problems.warning(head.last_line, "end", "no closing line with -1", "such a line ends a set",
                     "all points are there");
  else if (!after.starts_with("    -1"))
    problems.warning(head.last_line, "delimiter", "a line end before the closing line",
                     "the closing line with -1 follows the values directly", "read as the closing line");
}

/// The bytes of one number, in the order of this computer.
template <typename Real>
Real real_at(const char* bytes, bool big_endian) {
  char ordered[sizeof(Real)];
  std::memcpy(ordered, bytes, sizeof(Real));
  if (big_endian != (std::endian::native == std::endian::big)) std::reverse(ordered, ordered + sizeof(Real));
  Real value = 0;
  std::memcpy(&value, ordered, sizeof(Real));
  return value;
}

double value_at(const char* bytes, std::size_t size, bool big_endian) {
  return size == 4 ? real_at<float>(bytes, big_endian) : real_at<double>(bytes, big_endian);
}

std::vector<double> numbers_of_block(std::string_view data, const BinaryBlock& block, bool big_endian) {
  const PointLayout& layout = block.layout;
  std::vector<double> numbers;
  numbers.reserve(block.points * (layout.reals + 1));
  const char* at = data.data();
  for (std::size_t point = 0; point < block.points; ++point) {
    if (layout.abscissa > 0) numbers.push_back(value_at(at, layout.abscissa, big_endian));
    at += layout.abscissa;
    for (std::size_t i = 0; i < layout.reals; ++i, at += layout.value)
      numbers.push_back(value_at(at, layout.value, big_endian));
  }
  return numbers;
}

bool all_finite(const std::vector<double>& numbers, const FunctionHead& head, SetProblems& problems) {
  const auto bad = std::ranges::find_if(numbers, [](double value) { return !std::isfinite(value); });
  if (bad == numbers.end()) return true;
  const std::size_t point = static_cast<std::size_t>(bad - numbers.begin()) / numbers_per_point(head.function);
  problems.error(head.last_line, "values", fmt::format("point {} is {}", point + 1, *bad), "every number is finite",
                 "find the cause in the program that wrote the file; is the byte order right?");
  return false;
}

}  // namespace

std::optional<BinaryValues> read_binary_values(const UniversalSet& set, const FunctionHead& head,
                                               SetProblems& problems) {
  const auto form = binary_form(set, problems);
  if (!form) return std::nullopt;
  const std::string_view data = set.body.substr(head.values_at);
  const bool windows = set.body.substr(0, head.values_at).ends_with("\r\n");
  const auto block = find_block({data, windows ? "\r\n" : "\n"}, head, form->stated_bytes);
  if (!block) {
    const std::size_t left = data.size() / possible_layouts(head.function).front().bytes();
    problems.error(
        head.points_line, "points", fmt::format("{} announced, {} bytes stated", head.points, form->stated_bytes),
        left < head.points ? fmt::format("the file ends after at most {} points", left)
                           : std::string("a closing line with -1 follows the values, by one of both numbers"),
        left < head.points ? "was the file cut off?" : "was the file changed by a text program or a transfer?");
    return std::nullopt;
  }
  const std::size_t bytes = block->points * block->layout.bytes();
  report_deviations(set, head, *block, form->stated_bytes, data.substr(bytes), problems);
  auto numbers = numbers_of_block(data, *block, form->big_endian);
  if (!all_finite(numbers, head, problems)) return std::nullopt;
  return BinaryValues{std::move(numbers), head.values_at + bytes + block->closing_bytes};
}

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
