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

/// Rows of a table that a summary shows at most.
inline constexpr std::size_t rows_in_summary = 20;

/// The document on this screen. A summary has at most `rows_in_summary` rows of each table: the highest if the table
/// has heights, evenly spread ones along a frequency or speed, otherwise the first; and of columns that do not fit into
/// the width it leaves out those on the right, except words in the last column. A line below the table says so.
[[nodiscard]] std::string as_text(const Document& document, const project::DisplayUnits& display, const Screen& screen);

}  // namespace trivet::documents
