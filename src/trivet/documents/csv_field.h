// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace trivet::documents {

/// A number as the shortest text that reads back as the same number, without memory of its own to allocate: tables of
/// curves have millions of them.
class ShortestDigits {
 public:
  explicit ShortestDigits(double value);
  [[nodiscard]] std::string_view view() const { return {characters_.data(), size_}; }

 private:
  std::array<char, 32> characters_;  ///< "-1.7976931348623157e+308" has 24
  std::size_t size_;
};

/// A field of RFC 4180: in quotes if it contains commas, quotes or line breaks.
[[nodiscard]] inline std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

/// Shortest digits that read back the same number; empty for NaN.
[[nodiscard]] inline std::string csv_number(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

/// Appends a comma and the number.
inline void append_csv_number(std::string& line, double value) {
  line += ',';
  if (!std::isnan(value)) line += ShortestDigits(value).view();
}

template <typename T>
[[nodiscard]] std::string csv_number(const std::optional<T>& value) {
  return value ? fmt::format("{}", *value) : "";
}

}  // namespace trivet::documents
