// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/documents/document.h"
#include "trivet/documents/shown_table.h"
#include "trivet/documents/text_table.h"

/// A document on the screen.
namespace trivet::documents {
namespace {

std::string text_of(const Table& table, const project::DisplayUnits& display, Form form) {
  const ShownTable shown = shown_table(table, display, form);
  if (shown.headings.empty()) return "";
  if (shown.rows.empty()) return table.without_rows.empty() ? "" : table.without_rows + "\n";
  TextTable text(shown.headings, table.together, 150, shown.numbers);
  for (std::size_t i = 0; i < std::min(shown.rows.size(), table.most_rows); ++i) text.add(shown.rows[i].cells);
  const std::string rest = shown.rows.size() <= table.most_rows
      ? ""
      : fmt::format("  (the first {} of {}; {}--json gives all)\n", table.most_rows, shown.rows.size(),
                    table.file.empty() ? "" : "--csv or ");
  return (table.title.empty() ? "" : table.title + "\n") + text.text() + rest;
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
    if (!words.empty()) text += (sentence.place == Sentence::Place::paragraph ? "" : "  ") + words + "\n";
  }
  void operator()(const Group& group) const {
    if (!group.title.empty() && !group.parts.empty()) text += group.title + "\n";
    for (const Part& part : group.parts) std::visit(*this, part.content);
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
