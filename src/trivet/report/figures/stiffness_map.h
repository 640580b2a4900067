// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/elements/law.h"
#include "trivet/report/drawing/svg_canvas.h"

namespace trivet::report {

inline constexpr double stiffness_map_height = 610;  ///< [pixels], width 980

/// Draws a 12×12 as a signed heat map: each entry over √(K_ii K_jj) as colour and number; next to it the diagonal with
/// its units.
void draw_stiffness_map(SvgCanvas& canvas, PixelPoint corner, const elements::Matrix12& stiffness);

}  // namespace trivet::report
