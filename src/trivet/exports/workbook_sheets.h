// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/exports/content.h"

namespace trivet::exports {

struct SheetColumn {
  std::string heading;
  std::string unit;
  std::vector<double> numbers;
  std::vector<std::string> texts;  ///< instead of numbers
};

/// A sheet with columns of one length.
struct Sheet {
  std::string name;
  std::vector<SheetColumn> columns;
  bool charted = false;  ///< amplitudes over a frequency, or results over time or speed
};

/// The input, the requirements of the case with their margins, and a sheet for each list of rows, in the units of the
/// display.
/// @param lost  receives what no sheet holds
[[nodiscard]] std::vector<Sheet> workbook_sheets(const Content& content, const foundation::Progress& progress,
                                                 std::vector<std::string>& lost);

inline constexpr const char* sheet_of_charts = "charts";  ///< no other sheet has this name

}  // namespace trivet::exports
