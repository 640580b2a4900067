// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/report/drawing/svg_canvas.h"
#include "trivet/study/explain/element_summary.h"

namespace trivet::report {

inline constexpr double law_loop_plot_height = 330;  ///< [pixels], width 980

/// Draws closed loops of force over deflection at several amplitudes, one colour each.
void draw_law_loops(SvgCanvas& canvas, PixelPoint corner, const study::ElementLaws& laws,
                    const project::ShownUnits& display);

}  // namespace trivet::report
