// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>

#include "trivet/documents/shortest_digits.h"

namespace trivet::documents {

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
