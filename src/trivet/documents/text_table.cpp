// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/documents/text_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/index.h"

namespace trivet::documents {
namespace {

bool is_number(const std::string& text) {
  return !text.empty() &&
      (text == "–" || text == "∞" || text.find_first_not_of("0123456789+-.e%°") == std::string::npos);
}

constexpr std::size_t gap = 3;  // characters between columns

/// The first column of a row, and the columns `first` … `last` − 1.
std::string line(const std::vector<std::string>& row, std::size_t first, std::size_t last,
                 const std::vector<std::size_t>& widest, const std::vector<bool>& numeric) {
  std::string text;
  const auto add = [&](std::size_t c) {
    const std::string pad(widest[c] - width_on_screen(row[c]), ' ');
    text += (c == 0 ? "  " : "   ") + (numeric[c] ? pad + row[c] : row[c] + pad);
  };
  add(0);
  for (std::size_t c = first; c < last; ++c) add(c);
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

}  // namespace

std::size_t width_on_screen(const std::string& text) {
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };  // a character of UTF-8
  return text.size() - to_size(std::ranges::count_if(text, continues));
}

std::string number_text(double value, int digits) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return value > 0 ? "∞" : "-∞";
  return fmt::format("{:.{}g}", value == 0 ? 0.0 : value, digits);
}

std::string percent(double share) {
  constexpr double round_off = 1e-9, one_decimal = 5e-4;
  const double size = std::abs(share);
  return size > round_off && size < one_decimal ? fmt::format("{:.1g} %", 100 * share)
                                                : fmt::format("{:.1f} %", size > round_off ? 100 * share : 0.0);
}

double without_round_off(double value, double largest) {
  constexpr double round_off = 1e-12;
  return std::abs(value) > round_off * std::abs(largest) ? value : 0;
}

std::string TextTable::text() const {
  const std::size_t columns = rows_.front().size();
  std::vector<std::size_t> widest(columns, 0);
  std::vector<bool> numeric = numbers_.empty() ? std::vector<bool>(columns, true) : numbers_;
  for (std::size_t r = 0; r < rows_.size(); ++r)
    for (std::size_t c = 0; c < columns; ++c) {
      widest[c] = std::max(widest[c], width_on_screen(rows_[r][c]));
      if (numbers_.empty() && r > 0 && !rows_[r][c].empty() && !is_number(rows_[r][c])) numeric[c] = false;
    }
  std::string text;
  for (std::size_t first = 1; first == 1 || first < columns;) {
    std::size_t last = std::min(first + together_, columns), wide = 2 + widest[0];
    for (std::size_t c = first; c < last; ++c) wide += gap + widest[c];
    for (std::size_t next = last; next < columns; last = next) {
      const std::size_t end = std::min(next + together_, columns);
      for (std::size_t c = next; c < end; ++c) wide += gap + widest[c];
      if (wide > screen_) break;
      next = end;
    }
    if (first > 1) text += "\n";
    for (const auto& row : rows_) text += line(row, first, last, widest, numeric);
    first = std::max(last, first + 1);
  }
  return text;
}

}  // namespace trivet::documents
