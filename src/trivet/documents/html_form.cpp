// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/documents/document.h"
#include "trivet/documents/html_table.h"
#include "trivet/documents/shown_table.h"

/// A document on the page.
namespace trivet::documents {
namespace {

/// Numbers stay on one line with their units.
std::string on_one_line(const std::string& text) {
  std::string line;
  for (const char c : text) line += c == ' ' ? "\u00a0" : std::string(1, c);
  return line;
}

const char* style_of(Mark mark) {
  return mark == Mark::bad ? "failed" : mark == Mark::minor ? "minor" : mark == Mark::doubt ? "unjudged" : "";
}

std::string html_of(const Table& table, const project::DisplayUnits& display) {
  const ShownTable shown = shown_table(table, display, on_page);
  if (shown.headings.empty()) return "";
  if (shown.rows.empty()) return table.without_rows.empty() ? "" : hint(table.without_rows);
  std::vector<Cell> headings;
  for (std::size_t c = 0; c < shown.headings.size(); ++c) headings.push_back({shown.headings[c], shown.numbers[c]});
  std::vector<documents::Row> rows;
  for (const ShownTable::Row& one : shown.rows) {
    documents::Row& row = rows.emplace_back();
    row.style = style_of(one.mark);
    for (std::size_t c = 0; c < one.cells.size(); ++c)
      row.cells.push_back(
          {.text = shown.numbers[c] ? on_one_line(one.cells[c]) : one.cells[c], .number = shown.numbers[c]});
  }
  const std::string html = html_table(headings, rows, table.records ? "records" : "");
  if (table.folded) return documents::folded(table.title, html);
  return (table.title.empty() ? "" : paragraph(table.title)) + html;
}

class Page {
 public:
  explicit Page(const project::DisplayUnits& display) : display_(display) {}

  void operator()(const Table& table) {
    if (table.forms & on_page) add(html_of(table, display_));
  }
  void operator()(const Sentence& sentence) {
    if (!(sentence.forms & on_page)) return;
    const std::string words = shown_sentence(sentence, display_);
    if (words.empty()) return;
    if (sentence.place == Sentence::Place::item) items_ += "<li>" + escaped(words) + "</li>";
    else add(sentence.place == Sentence::Place::note ? hint(words) : paragraph(words));
  }
  void operator()(const Group& group) {
    Page inner(display_);
    Page& page = group.title.empty() ? *this : inner;
    for (const Part& part : group.parts) std::visit(page, part.content);
    if (const std::string html = inner.html(); !html.empty()) add(documents::folded(group.title, html));
  }
  template <typename Other>
  void operator()(const Other&) {}

  [[nodiscard]] std::string html() {
    add("");
    return html_;
  }

 private:
  void add(const std::string& html) {
    if (!items_.empty()) html_ += "<ul class=\"sentences\">" + items_ + "</ul>\n";
    items_.clear();
    html_ += html;
  }

  const project::DisplayUnits& display_;
  std::string html_, items_;
};

}  // namespace

std::string as_html(const Document& document, const project::DisplayUnits& display) {
  Page page(display);
  for (const Part& part : document.parts) std::visit(page, part.content);
  return page.html();
}

}  // namespace trivet::documents
