// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/documents/html_table.h"

#include <fmt/format.h>

#include <cmath>

namespace trivet::documents {
namespace {

constexpr std::size_t tall_from = 19;  // rows; from this number on the table scrolls

const char* class_of(Tone tone) {
  return tone == Tone::bad ? "bad" : tone == Tone::good ? "good" : tone == Tone::doubt ? "unsure" : "quiet";
}

std::string content(const Cell& c) {
  const std::string text = c.html ? c.text : escaped(c.text);
  return c.tone == Tone::plain ? text : fmt::format("<span class=\"{}\">{}</span>", class_of(c.tone), text);
}

/// @param heading  of a row that is a record on narrow screens; else empty
std::string table_cell(const Cell& c, const std::string& heading) {
  return fmt::format("<td{}{}{}>{}</td>", heading.empty() ? "" : " data-heading=\"" + escaped(heading) + "\"",
                     c.number ? " class=\"number\"" : "",
                     c.columns > 1 ? fmt::format(" colspan=\"{}\"", c.columns) : "", content(c));
}

/// A heading whose unit stays on one line with the word before it.
std::string heading(const Cell& c) {
  std::string text;
  bool in_unit = false;
  for (std::size_t i = 0; i < c.text.size(); ++i) {
    if (c.text[i] == '[' || c.text.compare(i, 2, " [") == 0) in_unit = true;
    else if (c.text[i] == ']') in_unit = false;
    text += in_unit && c.text[i] == ' ' ? "\u00a0" : std::string(1, c.text[i]);
  }
  std::string html = escaped(text);
  for (const std::string level : {"0-p]", "p-p]"})  // a line may end after a hyphen
    if (html.ends_with(level))
      html.replace(html.size() - level.size(), level.size(), "<span class=\"level\">" + level + "</span>");
  return fmt::format("<th scope=\"col\"{}>{}</th>", c.number ? " class=\"number\"" : "", html);
}

}  // namespace

std::string aligned_number(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  if (value == 0) return "0";
  std::string text = fmt::format("{:#.{}g}", value, digits);
  // fmt writes one zero after the point of a number that needs none: "1116.0" with four digits.
  const std::size_t point = text.find('.'), first = text.find_first_of("123456789");
  if (first < point && point - first >= static_cast<std::size_t>(digits)) text.erase(point, text.find('e') - point);
  return text;
}

Cell right(std::string text) { return {std::move(text), true}; }

void add_frequency(std::vector<Cell>& row, double angular_frequency, const project::DisplayUnits& display) {
  row.push_back(right(aligned_number(shown_frequency(display, angular_frequency), 6)));
}

Cell verdict_cell(bool passed, const std::string& yes, const std::string& no) {
  return {passed ? "✓ " + yes : "✗ " + no, false, passed ? Tone::good : Tone::bad};
}

Cell missing_verdict_cell(const std::string& words) { return {"? " + words, false, Tone::doubt}; }

Cell html_cell(std::string html) { return {std::move(html), false, Tone::plain, 1, true}; }

std::string section(const std::string& style, const std::string& title, const std::string& html) {
  return html.empty() ? ""
                      : fmt::format("<section class=\"{}\"><h2>{}</h2>\n{}</section>\n", style, escaped(title), html);
}

std::string hint(const std::string& text) { return paragraph(text, "hint"); }

std::string paragraph(const std::string& text, const std::string& style) {
  return fmt::format("<p{}>{}</p>\n", style.empty() ? "" : " class=\"" + style + "\"", escaped(text));
}

std::string folded(const std::string& title, const std::string& html) {
  return "<details><summary>" + escaped(title) + "</summary>" + html + "</details>\n";
}

std::string html_table(const std::vector<Cell>& headings, const std::vector<Row>& rows, const std::string& style) {
  std::string html =
      fmt::format("<div class=\"scroll{}\" tabindex=\"0\" role=\"group\" aria-label=\"table\"><table{}><thead><tr>",
                  rows.size() >= tall_from ? " tall" : "", style.empty() ? "" : " class=\"" + style + "\"");
  for (const Cell& each : headings) html += heading(each);
  html += "</tr></thead><tbody>";
  for (const Row& row : rows) {
    html += row.style.empty() ? "<tr>" : "<tr class=\"" + row.style + "\">";
    for (std::size_t c = 0; c < row.cells.size(); ++c)
      html += table_cell(row.cells[c], style == "records" ? headings[c].text : "");
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string html_table(const std::vector<Cell>& headings, const std::vector<std::vector<Cell>>& rows,
                       const std::string& style) {
  std::vector<Row> plain;
  for (const auto& cells : rows) plain.push_back({cells, ""});
  return html_table(headings, plain, style);
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

}  // namespace trivet::documents
