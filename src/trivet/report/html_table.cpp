// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/html_table.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "trivet/report/axis_ticks.h"
#include "trivet/report/svg_canvas.h"

namespace trivet::report {
namespace {

constexpr std::size_t tall_from = 19;  // rows; from this number on the table scrolls

std::string cell(const Cell& c, const char* tag) {
  const std::string text = c.bad ? "<span class=\"bad\">" + escaped(c.text) + "</span>" : escaped(c.text);
  return fmt::format("<{0}{1}>{2}</{0}>", tag, c.number ? " class=\"number\"" : "", text);
}

}  // namespace

Cell quantity_cell(double value, const std::string& unit) {
  if (!std::isfinite(value)) return {"∞", true};
  const UnitPrefix prefix = unit_prefix(std::abs(value), unit);
  return {fmt::format("{:.4g}\u00a0{}", value * prefix.factor, prefix.unit), true};
}

Cell number_cell(double value, int digits) {
  return {std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "∞", true};
}

Cell right(std::string text) { return {std::move(text), true}; }

Cell percent_cell(double share) { return right(fmt::format("{:.1f}\u00a0%", 100 * share)); }

Cell hertz_cell(double angular_frequency) { return number_cell(angular_frequency / (2 * std::numbers::pi), 5); }

std::string hint(const std::string& text) { return "<p class=\"hint\">" + escaped(text) + "</p>\n"; }

std::string folded(const std::string& title, const std::string& html) {
  return "<details><summary>" + escaped(title) + "</summary>" + html + "</details>\n";
}

std::string html_table(const std::vector<Cell>& headings, const std::vector<std::vector<Cell>>& rows) {
  std::string html =
      fmt::format("<div class=\"scroll{}\" tabindex=\"0\" role=\"region\" aria-label=\"table\"><table><thead><tr>",
                  rows.size() >= tall_from ? " tall" : "");
  for (const Cell& heading : headings) html += cell(heading, "th");
  html += "</tr></thead><tbody>";
  for (const auto& row : rows) {
    html += "<tr>";
    for (const Cell& each : row) html += cell(each, "td");
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace trivet::report
