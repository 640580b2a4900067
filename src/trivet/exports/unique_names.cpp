// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/unique_names.h"

#include <cstddef>

namespace trivet::exports {

namespace {

bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xc0u) == 0x80u; }

}  // namespace

std::u32string code_points(const std::string& text) {
  constexpr char32_t replacement = 0xfffd;
  std::u32string points;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = lead < 0x80 ? 1 : lead >> 5 == 6 ? 2 : lead >> 4 == 14 ? 3 : lead >> 3 == 30 ? 4 : 0;
    bool complete = length != 0 && i + length <= text.size();
    for (std::size_t k = 1; complete && k < length; ++k) complete = is_continuation(text[i + k]);
    if (!complete) {
      points += replacement;
      ++i;
      continue;
    }
    char32_t point = length == 1 ? lead : lead & (0xffu >> (length + 1));
    for (std::size_t k = 1; k < length; ++k) point = point << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3fu);
    points += point;
    i += length;
  }
  return points;
}

std::u16string utf16(const std::string& text) {
  constexpr char32_t first_pair = 0x10000;
  std::u16string units;
  for (const char32_t point : code_points(text)) {
    if (point < first_pair) {
      units += static_cast<char16_t>(point);
    } else {
      units += static_cast<char16_t>(0xd800 + ((point - first_pair) >> 10));
      units += static_cast<char16_t>(0xdc00 + ((point - first_pair) & 0x3ff));
    }
  }
  return units;
}

}  // namespace trivet::exports
