// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/report/drawing/curve_panel.h"
#include "trivet/report/drawing/figures.h"

namespace trivet::report {

/// Draws samples of strokes with their texts, downwards from a corner.
void draw_key(SvgCanvas& canvas, PixelPoint corner, const std::vector<PanelCurve>& curves);

/// Panels under a title: one panel with its key to the right; several side by side, two or three in a row, with one key
/// for all if each stroke means the same in all of them, and otherwise each with its own above it. A page may break
/// between the rows.
[[nodiscard]] Figure panel_figure(const std::string& title, const std::string& file_name,
                                  const std::vector<PanelRow>& panels);

}  // namespace trivet::report
