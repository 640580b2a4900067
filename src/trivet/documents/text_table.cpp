// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/documents/text_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "trivet/foundation/index.h"

namespace trivet::documents {
namespace {

bool is_number(const std::string& text) {
  return !text.empty() &&
      (text == "–" || text == "∞" || text.find_first_not_of("0123456789+-.e%°") == std::string::npos);
}

constexpr std::size_t gap = 3;                  // characters between columns
constexpr std::size_t most_further_lines = 40;  // of a table whose columns do not fit beside each other

/// The given columns of a row.
std::string line(const std::vector<std::string>& row, const std::vector<std::size_t>& columns,
                 const std::vector<std::size_t>& widest, const std::vector<bool>& numeric) {
  std::string text;
  for (const std::size_t c : columns) {
    const std::string pad(widest[c] - width_on_screen(row[c]), ' ');
    text += (text.empty() ? "  " : "   ") + (numeric[c] ? pad + row[c] : row[c] + pad);
  }
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

TextTable::Layout TextTable::layout() const {
  const std::size_t columns = rows_.front().size();
  Layout found{std::vector<std::size_t>(columns, 0), numbers_.empty() ? std::vector<bool>(columns, true) : numbers_};
  for (std::size_t r = 0; r < rows_.size(); ++r)
    for (std::size_t c = 0; c < columns; ++c) {
      found.widest[c] = std::max(found.widest[c], width_on_screen(rows_[r][c]));
      if (numbers_.empty() && r > 0 && !rows_[r][c].empty() && !is_number(rows_[r][c])) found.numeric[c] = false;
    }
  return found;
}

std::string TextTable::text() const {
  const std::size_t columns = rows_.front().size();
  const auto [widest, numeric] = layout();
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
    std::vector<std::size_t> part = {0};
    for (std::size_t c = first; c < last; ++c) part.push_back(c);
    for (const auto& row : rows_) text += line(row, part, widest, numeric);
    first = std::max(last, first + 1);
  }
  return text;
}

FittedTable TextTable::fitted(const std::vector<bool>& kept) const {
  const std::size_t columns = rows_.front().size();
  const auto [widest, numeric] = layout();
  std::size_t all = 2 - gap;
  for (const std::size_t width : widest) all += gap + width;
  if (all <= screen_) return {text(), {}};
  std::vector<bool> shown(columns, false);
  std::size_t wide = 2 - gap;
  const auto add = [&](std::size_t column) {
    shown[column] = true;
    wide += gap + widest[column];
  };
  for (std::size_t c = 0; c < columns; ++c) {
    const bool is_last_word = c + 1 == columns && columns > 2 && !numeric[c], is_kept = c < kept.size() && kept[c];
    if (c == 0 || (together_ == 1 && (is_last_word || is_kept))) add(c);
  }
  const auto necessary = std::ranges::count(shown, true);
  if (wide > screen_) return {blocks(), {}};
  for (std::size_t first = 1; first < columns; first += together_) {
    std::size_t more = 0;
    for (std::size_t c = first; c < std::min(first + together_, columns); ++c) more += shown[c] ? 0 : gap + widest[c];
    if (wide + more > screen_) break;
    for (std::size_t c = first; c < std::min(first + together_, columns); ++c)
      if (!shown[c]) add(c);
  }
  if (necessary < 3 && std::ranges::count(shown, true) == necessary) return {blocks(), {}};
  FittedTable found;
  add_part(shown, found.text);
  const std::vector<std::vector<bool>> others = parts_without(shown);
  if (!others.empty() && !is_named_by_first_column() && columns * (rows_.size() - 1) <= most_further_lines)
    return {blocks(), {}};  // rows below each other could not be told apart
  if (is_named_by_first_column() && others.size() * (rows_.size() + 1) <= most_further_lines) {
    for (const std::vector<bool>& part : others) add_part(part, found.text += "\n");
    return found;
  }
  for (std::size_t c = 0; c < columns; ++c)
    if (!shown[c] && std::ranges::find(found.left_out, rows_.front()[c]) == found.left_out.end())
      found.left_out.push_back(rows_.front()[c]);
  return found;
}

/// Has each row another entry there?
bool TextTable::is_named_by_first_column() const {
  std::set<std::string> names;
  return std::ranges::all_of(rows_, [&](const auto& row) { return names.insert(row.front()).second; });
}

/// The first column with the others that are not shown, as many as fit at a time.
std::vector<std::vector<bool>> TextTable::parts_without(const std::vector<bool>& shown) const {
  const std::size_t columns = rows_.front().size();
  const std::vector<std::size_t> widest = layout().widest;
  std::vector<std::vector<bool>> parts;
  std::size_t wide = screen_;
  for (std::size_t first = 1; first < columns; first += together_) {
    std::size_t more = 0;
    const std::size_t end = std::min(first + together_, columns);
    for (std::size_t c = first; c < end; ++c) more += shown[c] ? 0 : gap + widest[c];
    if (more == 0) continue;
    if (wide + more > screen_) {
      parts.emplace_back(columns, false)[0] = true;
      wide = 2 + widest[0];
    }
    for (std::size_t c = first; c < end; ++c) parts.back()[c] = !shown[c];
    wide += more;
  }
  return parts;
}

void TextTable::add_part(const std::vector<bool>& shown, std::string& text) const {
  const auto [widest, numeric] = layout();
  std::vector<std::size_t> part;
  for (std::size_t c = 0; c < shown.size(); ++c)
    if (shown[c]) part.push_back(c);
  for (const auto& row : rows_) text += line(row, part, widest, numeric);
}

std::string TextTable::blocks() const {
  const std::vector<std::string>& header = rows_.front();
  std::string text;
  for (std::size_t r = 1; r < rows_.size(); ++r)
    for (std::size_t c = 0; c < header.size(); ++c)
      if (!rows_[r][c].empty())
        text +=
            fmt::format("{}{}{}{}\n", c == 0 ? "  " : "    ", header[c], header[c].empty() ? "" : ": ", rows_[r][c]);
  return text;
}

}  // namespace trivet::documents
