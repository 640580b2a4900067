// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/nonlinear/branch/stiffness_over_amplitude.h"
#include "trivet/project/text/shown_units.h"
#include "trivet/report/drawing/svg_canvas.h"

namespace trivet::report {

inline constexpr double amplitude_stiffness_plot_height = 600;  ///< [pixels], width 980

/// Draws magnitude and loss angle of the dynamic stiffness over the frequency, one colour for each amplitude.
void draw_amplitude_stiffness(SvgCanvas& canvas, PixelPoint corner,
                              const std::vector<nonlinear::AmplitudeStiffness>& curves,
                              const project::ShownUnits& display);

}  // namespace trivet::report
