// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/universal/universal_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/exchange/text/text_lines.h"
#include "trivet/exchange/universal/universal_sets.h"
#include "trivet/exchange/universal/universal_writing.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"

namespace trivet::exchange {

namespace {

std::optional<double> any_number(std::string_view text) {
  const auto plain = number(text);
  return plain ? plain : fortran_number(text);
}

bool begins_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }

/// Byte position of a column.
std::size_t byte_of_column(std::string_view line, std::size_t column) {
  std::size_t at = 0;
  for (std::size_t passed = 0; at < line.size(); ++at)
    if (begins_character(line[at]) && passed++ == column) break;
  return at;
}

/// The first 256 characters of Unicode are those of Latin-1.
std::string from_latin_1(std::string_view line) {
  std::string text;
  for (const char c : line) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      text += c;
    } else {
      text += static_cast<char>(0xC0 | byte >> 6);
      text += static_cast<char>(0x80 | (byte & 0x3F));
    }
  }
  return text;
}

}  // namespace

std::optional<std::vector<double>> numbers_between_blanks(std::string_view line) {
  std::vector<double> numbers;
  for (const std::string_view part : blank_separated(line)) {
    const auto value = any_number(part);
    if (!value) return std::nullopt;
    numbers.push_back(*value);
  }
  return numbers;
}

std::optional<std::vector<double>> numbers_in_columns(std::string_view line, FieldWidths widths, BlankFields blank) {
  std::vector<double> numbers;
  std::size_t at = 0;
  for (const int width : widths) {
    const std::string_view field = at < line.size() ? trimmed(line.substr(at, to_size(width))) : std::string_view{};
    at += to_size(width);
    if (field.empty() && blank == BlankFields::end_the_line) break;
    const auto value = field.empty() ? std::optional(0.0) : any_number(field);
    if (!value) return std::nullopt;
    numbers.push_back(*value);
  }
  if (at < line.size() && !trimmed(line.substr(at)).empty()) return std::nullopt;
  return numbers;
}

std::optional<std::vector<double>> numbers_of_record(std::string_view line, FieldWidths widths, std::size_t least) {
  auto separated = numbers_between_blanks(line);
  if (separated && separated->size() == widths.size()) return separated;
  if (auto in_columns = numbers_in_columns(line, widths, BlankFields::are_zero)) return in_columns;
  if (!separated || separated->size() < least || separated->size() > widths.size()) return std::nullopt;
  separated->resize(widths.size(), 0.0);
  return separated;
}

std::optional<int> as_whole_number(double value) {
  const bool in_range = std::abs(value) <= std::numeric_limits<int>::max();
  if (!in_range || value != std::floor(value)) return std::nullopt;
  return static_cast<int>(value);
}

std::optional<std::vector<int>> whole_numbers_of_record(std::string_view line, FieldWidths widths, std::size_t least) {
  const auto numbers = numbers_of_record(line, widths, least);
  if (!numbers) return std::nullopt;
  std::vector<int> whole;
  for (const double number : *numbers) {
    const auto value = as_whole_number(number);
    if (!value) return std::nullopt;
    whole.push_back(*value);
  }
  return whole;
}

std::string_view text_in_columns(std::string_view line, std::size_t first, std::size_t width) {
  const std::size_t begin = byte_of_column(line, first);
  const std::string_view rest = line.substr(begin);
  return trimmed(rest.substr(0, byte_of_column(rest, width)));
}

std::string readable_line(std::string_view line) {
  std::string text(line);
  std::ranges::replace(text, '\t', ' ');
  const std::string printable = foundation::on_one_line(text);
  return printable == text ? text : foundation::on_one_line(from_latin_1(text));
}

std::string unless_none(std::string_view text) {
  const std::string_view content = trimmed(text);
  return lower(content) == "none" ? std::string() : std::string(content);
}

namespace {

constexpr std::string_view no_text = "NONE";
constexpr std::size_t single_fields_per_line = 6;

bool is_none(std::string_view text) { return lower(trimmed(text)) == "none"; }
bool is_ascii(char c) { return c >= ' ' && c <= '~'; }

/// ? for each character that is not ASCII.
std::string in_ascii(std::string_view text) {
  std::string plain;
  for (const char c : text) {
    const bool continues_character = (static_cast<unsigned char>(c) & 0xC0) == 0x80;
    if (!continues_character) plain += is_ascii(c) ? c : '?';
  }
  return plain;
}

}  // namespace

bool fits_universal_line(std::string_view text) {
  return text.size() <= universal_id_width && !foundation::unprintable(text) && trimmed(text) == text &&
      !text.empty() && !is_none(text) && !is_delimiter(text);
}

bool fits_universal_field(std::string_view text, std::size_t width) {
  return text.size() <= width && in_ascii(text) == text && trimmed(text) == text && !is_none(text);
}

double as_universal_abscissa(double hertz) {
  require_finite(hertz, "an abscissa");
  return *number(trimmed(single_field(hertz)));
}

std::string opening_lines(int type) { return fmt::format("{:6d}\n{:6d}\n", -1, type); }
std::string closing_line_of_set() { return fmt::format("{:6d}\n", -1); }

std::string text_line(std::string_view text) {
  const std::string printable = foundation::on_one_line(text);
  std::string line(trimmed(foundation::shortened(printable, universal_id_width)));
  if (line.empty()) line = no_text;
  if (is_delimiter(line)) line = "\"" + line + "\"";  // -1 alone would close the set
  return line + "\n";
}

std::string text_field(std::string_view text, std::size_t width) {
  const std::string plain = in_ascii(text).substr(0, width);
  return fmt::format("{:<{}}", trimmed(plain).empty() ? no_text : std::string_view(plain), width);
}

std::string whole_field(int number, int width, const char* name) {
  std::string field = fmt::format("{:{}d}", number, width);
  if (std::ssize(field) > width)
    throw foundation::InvalidInput(
        fmt::format("{} {}: a universal file has {} characters for it", name, number, width));
  return field;
}

std::string single_field(double number) { return fmt::format("{:13.5E}", number); }
std::string double_field(double number) { return fmt::format("{:20.12E}", number); }

std::string single_lines(const std::vector<double>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    text += single_field(numbers[i]);
    if ((i + 1) % single_fields_per_line == 0 || i + 1 == numbers.size()) text += '\n';
  }
  return text;
}

void require_finite(double number, const char* name) {
  if (!std::isfinite(number)) throw foundation::InvalidInput(fmt::format("{} is {}, must be finite", name, number));
}

}  // namespace trivet::exchange
