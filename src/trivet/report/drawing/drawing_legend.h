// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/project/text/display_units.h"
#include "trivet/report/drawing/machine_symbols.h"

namespace trivet::report {

/// Draws the scale bar and the meaning of the symbols that a drawing uses, and how many names had no room.
/// @param right  end of its rows [pixels]  @param scale  [pixels/m]
/// @returns the lower end of the last row
double draw_drawing_legend(SvgCanvas& canvas, PixelPoint corner, double right, const DrawnMachine& machine,
                           bool over_given, double scale, const project::DisplayUnits& display,
                           const std::vector<std::string>& left_out);

/// Length of a scale bar about `wanted` long: 1, 2 or 5 times a power of ten of the shown unit.
struct ScaleBar {
  double pixels = 0;
  std::string label;  ///< "200 mm"
};
[[nodiscard]] ScaleBar scale_bar(double scale, double wanted, const project::DisplayUnits& display);

}  // namespace trivet::report
