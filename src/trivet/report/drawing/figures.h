// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/report/drawing/amplitude_range.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/study/analyses/case_results.h"

namespace trivet::report {

inline constexpr double half_figure_width = 485, quarter_figure_width = 240;  ///< [pixels]

/// One picture for print.
struct Figure {
  std::string title;
  std::string file_name;  ///< "01-machine.svg"
  std::string svg;
  std::vector<std::string> strips = {};  ///< the same in parts between which a page may break
  int in_row = 1;                        ///< so many of them are side by side: 1, 2 or 4

  /// For the page: the strips, or else the picture.
  [[nodiscard]] std::string html() const;
};

/// What the curves of a row of a group span, which decides on its axis.
[[nodiscard]] AmplitudeRange drawn_range(const study::ResponseResult& result, const std::vector<GroupedCurve>& series);

/// Characteristics of one case, one figure per body, point or element: translations (or forces) above, rotations (or
/// moments) below, amplitude left and phase right, peaks marked, limits as lines.
[[nodiscard]] std::vector<Figure> characteristics(const study::CaseResults& results);

/// All cases in small panels side by side: translations above, rotations below, for the first group of curves.
[[nodiscard]] Figure overview(const std::string& title, const std::vector<study::CaseResults>& cases);

}  // namespace trivet::report
