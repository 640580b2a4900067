// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace trivet::report {

/// A cell of a table; numbers are right-aligned.
struct Cell {
  std::string text;
  bool number = false;
  bool bad = false;  ///< a limit is violated
};

/// A value with an SI prefix and four digits: 0.00123 m → "1.23 mm"; "∞" if it is not finite.
[[nodiscard]] Cell quantity_cell(double value, const std::string& unit);
/// A plain number.
[[nodiscard]] Cell number_cell(double value, int digits = 4);

/// A right-aligned text: "–", "everywhere".
[[nodiscard]] Cell right(std::string text);
[[nodiscard]] Cell percent_cell(double share);
/// ω in rad/s as a frequency.
[[nodiscard]] Cell hertz_cell(double angular_frequency);

/// A table in the style of the page.
[[nodiscard]] std::string html_table(const std::vector<Cell>& headings, const std::vector<std::vector<Cell>>& rows);

/// A remark below a table, and a part that opens by a click.
[[nodiscard]] std::string hint(const std::string& text);
[[nodiscard]] std::string folded(const std::string& title, const std::string& html);

}  // namespace trivet::report
