// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "trivet/documents/shown_numbers.h"

namespace trivet::documents {

/// How a cell is coloured: a limit is violated, a check passed, a number is only round-off, something was not judged.
enum class Tone { plain, bad, good, quiet, doubt };

/// A cell of a table; numbers are right-aligned.
struct Cell {
  std::string text;
  bool number = false;
  Tone tone = Tone::plain;
  int columns = 1;    ///< that it covers
  bool html = false;  ///< `text` is HTML, not plain text
};

/// A row, with the style of the whole row: "failed", "unjudged", "minor" or "".
struct Row {
  std::vector<Cell> cells;
  std::string style;
};

/// A number with zeros at the end; "–" if it is not finite.
[[nodiscard]] std::string aligned_number(double value, int digits = 5);

/// A right-aligned text: "–", "everywhere".
[[nodiscard]] Cell right(std::string text);
/// ω in rad/s and as a frequency in Hz, two cells, or one cell in the unit of the display.
void add_frequency(std::vector<Cell>& row, double angular_frequency, const project::DisplayUnits& display);
/// "✓ ok" or "✗ FAILED".
[[nodiscard]] Cell verdict_cell(bool passed, const std::string& yes = "ok", const std::string& no = "FAILED");
/// A verdict that is missing: "? not judged".
[[nodiscard]] Cell missing_verdict_cell(const std::string& words);
[[nodiscard]] Cell html_cell(std::string html);

/// Text escaped for XML and HTML.
[[nodiscard]] std::string escaped(std::string_view text);

/// A table in the style of the page. @param style  class of the table: "matrix", "records" (on a narrow screen each row
/// is a list of its cells with their headings) or ""
[[nodiscard]] std::string html_table(const std::vector<Cell>& headings, const std::vector<Row>& rows,
                                     const std::string& style = "");
[[nodiscard]] std::string html_table(const std::vector<Cell>& headings, const std::vector<std::vector<Cell>>& rows,
                                     const std::string& style = "");

/// A section with its heading; empty without content. @param style  class of the section
[[nodiscard]] std::string section(const std::string& style, const std::string& title, const std::string& html);
/// A remark below a table, a paragraph, and a part that opens by a click.
[[nodiscard]] std::string hint(const std::string& text);
[[nodiscard]] std::string paragraph(const std::string& text, const std::string& style = "");
[[nodiscard]] std::string folded(const std::string& title, const std::string& html);

}  // namespace trivet::documents
