// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/universal/universal_lines.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/exchange/text/text_lines.h"
#include "trivet/exchange/universal/universal_sets.h"
#include "trivet/exchange/universal/universal_writing.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"

namespace trivet::exchange {
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
