// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/documents/document.h"

namespace trivet::documents {

/// What people see of a table, on the screen and on the page.
struct ShownTable {
  struct Row {
    std::vector<std::string> cells;
    Mark mark = Mark::plain;
  };
  std::vector<std::string> headings;
  std::vector<bool> numbers;      ///< right-aligned columns
  std::vector<bool> frequencies;  ///< columns of frequencies and speeds
  std::vector<Row> rows;
};
[[nodiscard]] ShownTable shown_table(const Table& table, const project::DisplayUnits& display, Form form);

/// A number with so many significant digits, zeros at the end included; "–" for NaN, "∞".
[[nodiscard]] std::string fixed_digits(double value, int digits);

/// A number in a sentence with its unit: "12.5 Hz", "0.3 mm p-p".
[[nodiscard]] std::string shown_quantity(const Quantity& quantity, const project::DisplayUnits& display);
[[nodiscard]] std::string shown_sentence(const Sentence& sentence, const project::DisplayUnits& display);

}  // namespace trivet::documents
