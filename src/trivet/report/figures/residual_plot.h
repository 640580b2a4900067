// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/model/system.h"
#include "trivet/report/drawing/svg_canvas.h"

namespace trivet::report {

/// Height [pixels], with width 980; outliers are listed below the plot.
[[nodiscard]] double residual_plot_height(const std::vector<model::Residual>& residuals);

/// Draws the residual of each reading over its standard deviation, in the order of the data; outliers marked, numbered
/// and named.
void draw_residuals(SvgCanvas& canvas, PixelPoint corner, const std::vector<model::Residual>& residuals);

}  // namespace trivet::report
