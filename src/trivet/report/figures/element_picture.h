// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "trivet/model/system.h"
#include "trivet/nonlinear/branch/stiffness_over_amplitude.h"
#include "trivet/project/project.h"
#include "trivet/project/text/display_units.h"
#include "trivet/report/drawing/svg_canvas.h"
#include "trivet/study/explain/element_summary.h"

namespace trivet::report {

inline constexpr double amplitude_stiffness_plot_height = 600;  ///< [pixels], width 980

/// Draws magnitude and loss angle of the dynamic stiffness over the frequency, one colour for each amplitude.
void draw_amplitude_stiffness(SvgCanvas& canvas, PixelPoint corner,
                              const std::vector<nonlinear::AmplitudeStiffness>& curves,
                              const project::DisplayUnits& display);

inline constexpr double law_loop_plot_height = 330;  ///< [pixels], width 980

/// Draws closed loops of force over deflection at several amplitudes, one colour each.
void draw_law_loops(SvgCanvas& canvas, PixelPoint corner, const study::ElementLaws& laws,
                    const project::DisplayUnits& display);

/// Height [pixels], with width 980; outliers are listed below the plot.
[[nodiscard]] double residual_plot_height(const std::vector<model::Residual>& residuals);

/// Draws the residual of each reading over its standard deviation, in the order of the data; outliers marked, numbered
/// and named.
void draw_residuals(SvgCanvas& canvas, PixelPoint corner, const std::vector<model::Residual>& residuals);

/// One element as a static SVG: its 12×12 as a heat map; below it the residuals of the readings from which it was
/// identified, and |D(ω)| of its end K if it has mass, relaxes or is a table.
[[nodiscard]] std::string element_picture(const project::Case& variant, std::size_t element);

}  // namespace trivet::report
