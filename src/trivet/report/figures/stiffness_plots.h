// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/elements/law.h"
#include "trivet/report/drawing/svg_canvas.h"
#include "trivet/response/steady/frequency_grid.h"

namespace trivet::report {

inline constexpr double stiffness_map_height = 610;  ///< [pixels], width 980

/// Draws a 12×12 as a signed heat map: each entry over √(K_ii K_jj) as colour and number; next to it the diagonal with
/// its units.
void draw_stiffness_map(SvgCanvas& canvas, PixelPoint corner, const elements::Matrix12& stiffness);

inline constexpr double dynamic_stiffness_plot_height = 330;  ///< [pixels], width 980

/// Frequency band in which the dynamic stiffness of a law is drawn [rad/s]: its table, its own natural frequencies, its
/// relaxation times. Empty if it is constant except for a dashpot.
[[nodiscard]] std::optional<assembly::Band> dynamic_band(const elements::Law& law);

/// Draws |D_ii| of end K, N held, over frequency; translations left, rotations right, own natural frequencies as lines.
void draw_dynamic_stiffness(SvgCanvas& canvas, PixelPoint corner, const elements::Law& law, const assembly::Band& band);

}  // namespace trivet::report
