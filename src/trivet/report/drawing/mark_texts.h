// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/report/drawing/curve_panel.h"

namespace trivet::report {

/// Draws marked points, with texts beside them of which none lies over another one or over another mark: above, below
/// or beside, inside the frame if there is room. A text without any room is left out.
void draw_panel_marks(SvgCanvas& canvas, const PlotPanel& panel, const std::vector<PanelMark>& marks);

}  // namespace trivet::report
