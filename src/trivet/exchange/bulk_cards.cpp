// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/bulk_cards.h"

#include "trivet/exchange/text/text_lines.h"

namespace trivet::exchange {
namespace {

constexpr std::size_t small_width = 8, large_width = 16, small_fields = 8, large_fields = 4;

struct CardLine {
  std::string_view first;  ///< name or mark of continuation
  std::vector<std::string_view> fields;
};

CardLine free_fields(std::string_view line) {
  const auto parts = cells(line, ',');
  CardLine result{parts.front(), {}};
  const std::size_t count = result.first.find('*') != std::string_view::npos ? large_fields : small_fields;
  for (std::size_t i = 1; i <= count; ++i) result.fields.push_back(i < parts.size() ? parts[i] : std::string_view{});
  return result;
}

CardLine fixed_fields(std::string_view line) {
  CardLine result{trimmed(line.substr(0, small_width)), {}};
  const bool large = result.first.find('*') != std::string_view::npos;
  const std::size_t width = large ? large_width : small_width;
  for (std::size_t i = 0; i < (large ? large_fields : small_fields); ++i) {
    const std::size_t at = small_width + i * width;
    result.fields.push_back(at < line.size() ? trimmed(line.substr(at, width)) : std::string_view{});
  }
  return result;
}

bool is_continuation(std::string_view first) {
  return first.empty() || first.starts_with('+') || first.starts_with('*');
}

}  // namespace

std::string without_tabs(std::string_view text) {
  std::string result;
  std::size_t column = 0;
  for (const char c : text) {
    if (c == '\t') {
      const std::size_t blanks = small_width - column % small_width;
      result.append(blanks, ' ');
      column += blanks;
    } else {
      result += c;
      column = c == '\n' ? 0 : column + 1;
    }
  }
  return result;
}

std::vector<Card> bulk_cards(std::string_view text, std::string_view name) {
  std::vector<Card> cards;
  bool wanted = false;
  for (Lines lines(text); lines.next();) {
    const std::string_view line = lines.line().substr(0, lines.line().find('$'));
    if (trimmed(line).empty()) continue;
    const CardLine parts = line.find(',') != std::string_view::npos ? free_fields(line) : fixed_fields(line);
    if (!is_continuation(parts.first)) {
      const std::string card = lower(parts.first.substr(0, parts.first.find('*')));
      if (card == "enddata") break;
      wanted = card == name;
      if (wanted) cards.push_back({lines.number(), {}});
    }
    if (!wanted) continue;
    for (const std::string_view field : parts.fields) cards.back().fields.push_back({field, lines.number()});
  }
  return cards;
}

}  // namespace trivet::exchange
