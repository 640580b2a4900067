// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/text/text_lines.h"
#include "trivet/foundation/plain_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace trivet::exchange {
namespace {

constexpr std::string_view blanks = " \t\r\f\v";
/// Longer than any number that a program prints.
constexpr std::size_t longest_number = 64;

}  // namespace

bool Lines::next() {
  if (rest_.empty()) return false;
  const std::size_t end = rest_.find('\n');
  line_ = rest_.substr(0, end);
  rest_ = end == std::string_view::npos ? std::string_view{} : rest_.substr(end + 1);
  if (line_.ends_with('\r')) line_.remove_suffix(1);
  ++number_;
  return true;
}

std::string with_line_feeds(std::string text) {
  if (text.find('\n') == std::string::npos && text.find('\0') == std::string::npos)
    std::ranges::replace(text, '\r', '\n');
  return text;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string_view> blank_separated(std::string_view line) {
  std::vector<std::string_view> found;
  for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;
       at = line.find_first_not_of(blanks, at)) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    found.push_back(line.substr(at, end - at));
    at = end;
  }
  return found;
}

std::vector<std::string_view> cells(std::string_view line, char separator) {
  std::vector<std::string_view> found;
  if (trimmed(line).empty()) return found;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find(separator, at), line.size());
    found.push_back(trimmed(line.substr(at, end - at)));
    at = end + 1;
  }
  return found;
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest_shown = 40;
  return foundation::quoted(text, longest_shown);
}

std::optional<double> number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<double> fortran_number(std::string_view text) {
  if (text.size() > longest_number) return std::nullopt;
  std::string plain;
  for (const char c : text) {
    const char before = plain.empty() ? ' ' : plain.back();
    const bool after_mantissa = std::isdigit(static_cast<unsigned char>(before)) || before == '.';
    if ((c == '+' || c == '-') && after_mantissa) plain += 'e';
    plain += c == 'd' || c == 'D' ? 'e' : c;
  }
  return number(plain);
}

std::optional<int> whole_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

void FileProblems::error(int line, std::string subject, std::string finding, std::string rule, std::string remedy) {
  ++errors_;
  problems_.error(std::move(subject), std::move(finding), std::move(rule), std::move(remedy)).origin = {source_, line,
                                                                                                        0};
}

void FileProblems::warning(int line, std::string subject, std::string finding, std::string rule, std::string remedy) {
  problems_.warning(std::move(subject), std::move(finding), std::move(rule), std::move(remedy)).origin = {source_, line,
                                                                                                          0};
}

}  // namespace trivet::exchange
