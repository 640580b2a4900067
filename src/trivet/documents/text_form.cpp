// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "trivet/documents/document.h"
#include "trivet/documents/screen.h"
#include "trivet/documents/shown_table.h"
#include "trivet/documents/text_table.h"
#include "trivet/foundation/plain_text.h"

/// A document on the screen.
namespace trivet::documents {
namespace {

bool is_along_an_axis(const Table& table, Form form) {
  const std::vector<UsedColumn> columns = used_columns(table, table.people, form);
  if (columns.empty()) return false;
  const Kind kind = columns.front().column->kind;
  return kind == Kind::frequency || kind == Kind::speed;
}

/// Which rows of a table the screen shows, and in words.
struct KeptRows {
  std::vector<std::size_t> places;  ///< ascending
  std::string words;                ///< "20 highest"
};

/// Of too many rows the highest, those evenly spread along an axis, or the first.
KeptRows kept_rows(const Table& table, std::size_t rows, std::size_t most, Form form, bool summary) {
  if (summary && !table.height && is_along_an_axis(table, form))
    return {spread_rows(rows, most), fmt::format("{} evenly spread", most)};
  KeptRows kept{std::vector<std::size_t>(rows),
                table.height ? fmt::format("{} {}", most, table.what_is_high) : fmt::format("first {}", most)};
  std::iota(kept.places.begin(), kept.places.end(), std::size_t{0});
  const auto height = [&](std::size_t place) {
    const double value = table.height(table.people_rows ? (*table.people_rows)[place] : place);
    return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  };
  if (table.height) std::ranges::stable_sort(kept.places, std::ranges::greater{}, height);
  kept.places.resize(most);
  std::ranges::sort(kept.places);
  return kept;
}

/// @param screen  null: in tables of this width, with the rows that the table itself limits
std::string text_of(const Table& table, const project::DisplayUnits& display, Form form, std::size_t width,
                    const Screen* screen) {
  const ShownTable shown = shown_table(table, display, form);
  if (shown.headings.empty()) return "";
  if (shown.rows.empty()) return table.without_rows.empty() ? "" : table.without_rows + "\n";
  const std::size_t rows = shown.rows.size();
  const bool summary = screen && !screen->full;
  const std::size_t most = !screen ? table.most_rows : summary ? std::min(table.most_rows, rows_in_summary) : rows;
  TextTable text(shown.headings, table.together, width, shown.numbers);
  std::string rest;
  if (rows <= most) {
    for (const ShownTable::Row& row : shown.rows) text.add(row.cells);
  } else {
    const KeptRows kept = kept_rows(table, rows, most, form, summary);
    for (const std::size_t place : kept.places) text.add(shown.rows[place].cells);
    rest = summary ? fmt::format("  … {} more rows, these are the {}: --full\n", rows - most, kept.words)
                   : fmt::format("  (the {} of {}; {}--json gives all)\n", kept.words, rows,
                                 table.file.empty() ? "" : "--csv or ");
  }
  const std::string title = table.title.empty() ? "" : table.title + "\n";
  if (!summary) return title + text.text() + rest;
  const FittedTable fitted = text.fitted(shown.frequencies);
  if (!fitted.left_out.empty())
    rest += fmt::format("  … without {}, for which the screen is too narrow: --full\n",
                        foundation::comma_separated(fitted.left_out));
  return title + fitted.text + rest;
}

struct Printing {
  const project::DisplayUnits& display;
  Form form;
  std::string& text;
  std::size_t width = width_in_files;
  const Screen* screen = nullptr;

  void operator()(const Table& table) const {
    if (table.forms & form) text += text_of(table, display, form, width, screen);
  }
  void operator()(const Sentence& sentence) const {
    if (!(sentence.forms & form)) return;
    const std::string words = shown_sentence(sentence, display);
    if (words.empty()) return;
    constexpr std::size_t widest = 118;
    const bool indented = sentence.place == Sentence::Place::note || sentence.place == Sentence::Place::item;
    text += (indented ? "  " : "") +
        (sentence.place == Sentence::Place::text ? with_line_breaks(words, std::min(width, widest)) : words) + "\n";
  }
  void operator()(const Group& group) const {
    const bool has_title = !group.title.empty() && !group.parts.empty();
    if ((has_title || group.in_list) && !text.empty() && !text.ends_with("\n\n")) text += "\n";
    if (has_title) text += group.title + "\n";
    for (const Part& part : group.parts) std::visit(*this, part.content);
    if (group.in_list) text += "\n";
  }
  template <typename Other>
  void operator()(const Other&) const {}
};

}  // namespace

std::string as_text(const Document& document, const project::DisplayUnits& display, Form form) {
  return as_text(document, display, form, width_in_files);
}

std::string as_text(const Document& document, const project::DisplayUnits& display, Form form, std::size_t width) {
  std::string text;
  for (const Part& part : document.parts) std::visit(Printing{display, form, text, width}, part.content);
  return text;
}

std::string as_text(const Document& document, const project::DisplayUnits& display, const Screen& screen) {
  std::string text;
  for (const Part& part : document.parts)
    std::visit(Printing{display, on_screen, text, screen.width, &screen}, part.content);
  return text;
}

}  // namespace trivet::documents
