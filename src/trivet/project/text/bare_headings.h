// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/text/csv_table.h"

/// Tables that programs write with row numbers, or without names of their columns.
namespace trivet::project {

/// First row of a table whose cells are all numbers.
struct BareHeading {
  int line = 0;                 ///< in the file; 0: the table has a header
  bool counts_columns = false;  ///< it is 0, 1 … or 1, 2 …
  bool whole_below = false;     ///< rows below it have whole numbers, too
};

/// Removes the first column, which has no name, if it counts the rows, with a warning of the table; otherwise an error.
[[nodiscard]] foundation::Problems drop_row_numbers(CsvTable& table, int header_line);

/// Keeps a bare first row as numbers, or removes it if it counts the columns, with a warning of the table. Errors: it
/// may be either, or the first column does not increase.
[[nodiscard]] foundation::Problems judge_bare_heading(CsvTable& table, const BareHeading& heading);

}  // namespace trivet::project
