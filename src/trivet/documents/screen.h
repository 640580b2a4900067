// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "trivet/documents/document.h"

namespace trivet::documents {

/// What a document is printed on.
struct Screen {
  std::size_t width = 100;  ///< [characters]
  bool full = false;        ///< every row and every column; otherwise what a person reads at once
};

/// Width of tables in a text that is on no screen [characters].
inline constexpr std::size_t width_in_files = 150;

/// Rows of a table that a summary shows at most.
inline constexpr std::size_t rows_in_summary = 20;

/// The document on this screen. A summary has at most `rows_in_summary` rows of each table: the highest if the table
/// has heights, evenly spread ones along a frequency or speed, otherwise the first; and of columns that do not fit into
/// the width it leaves out those on the right, except frequencies and words in the last column. A line below the table
/// names them.
[[nodiscard]] std::string as_text(const Document& document, const project::DisplayUnits& display, const Screen& screen);

/// The document in one of its forms, with the rows that each table limits itself, in tables of this width.
[[nodiscard]] std::string as_text(const Document& document, const project::DisplayUnits& display, Form form,
                                  std::size_t width);

/// The text with longer lines broken between words; what follows is indented further. A word longer than a line stays.
[[nodiscard]] std::string with_line_breaks(const std::string& text, std::size_t width);

}  // namespace trivet::documents
