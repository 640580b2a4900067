// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "trivet/documents/document.h"
#include "trivet/documents/shown_table.h"
#include "trivet/documents/text_table.h"

/// A document on the screen.
namespace trivet::documents {
namespace {

/// Places of the rows that the screen shows, ascending: of too many the highest, or the first.
std::vector<std::size_t> kept_rows(const Table& table, std::size_t rows) {
  std::vector<std::size_t> places(rows);
  std::iota(places.begin(), places.end(), std::size_t{0});
  if (rows <= table.most_rows) return places;
  const auto height = [&](std::size_t place) {
    const double value = table.height(table.people_rows ? (*table.people_rows)[place] : place);
    return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  };
  if (table.height) std::ranges::stable_sort(places, std::ranges::greater{}, height);
  places.resize(table.most_rows);
  std::ranges::sort(places);
  return places;
}

std::string text_of(const Table& table, const project::DisplayUnits& display, Form form) {
  const ShownTable shown = shown_table(table, display, form);
  if (shown.headings.empty()) return "";
  if (shown.rows.empty()) return table.without_rows.empty() ? "" : table.without_rows + "\n";
  TextTable text(shown.headings, table.together, 150, shown.numbers);
  for (const std::size_t place : kept_rows(table, shown.rows.size())) text.add(shown.rows[place].cells);
  const std::string rest = shown.rows.size() <= table.most_rows
      ? ""
      : fmt::format(
            "  (the {} of {}; {}--json gives all)\n",
            table.height ? fmt::format("{} highest", table.most_rows) : fmt::format("first {}", table.most_rows),
            shown.rows.size(), table.file.empty() ? "" : "--csv or ");
  return (table.title.empty() ? "" : table.title + "\n") + text.text() + rest;
}

/// Lines of at most 118 characters; those after the first are indented.
std::string wrapped(const std::string& text) {
  constexpr std::size_t width = 118;
  std::string lines, line;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t space = std::min(text.find(' ', from), text.size());
    const std::string word = text.substr(from, space - from);
    if (!line.empty() && width_on_screen(line) + 1 + width_on_screen(word) > width) {
      lines += line + "\n";
      line = "    " + word;
    } else {
      line += (line.empty() ? "" : " ") + word;
    }
    from = space + 1;
  }
  return lines + line;
}

struct Printing {
  const project::DisplayUnits& display;
  Form form;
  std::string& text;

  void operator()(const Table& table) const {
    if (table.forms & form) text += text_of(table, display, form);
  }
  void operator()(const Sentence& sentence) const {
    if (!(sentence.forms & form)) return;
    const std::string words = shown_sentence(sentence, display);
    if (words.empty()) return;
    const bool indented = sentence.place == Sentence::Place::note || sentence.place == Sentence::Place::item;
    text += (indented ? "  " : "") + (sentence.place == Sentence::Place::text ? wrapped(words) : words) + "\n";
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
  std::string text;
  for (const Part& part : document.parts) std::visit(Printing{display, form, text}, part.content);
  return text;
}

}  // namespace trivet::documents
