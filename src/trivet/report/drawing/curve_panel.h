// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/report/drawing/plot_panel.h"

namespace trivet::report {

/// A curve and its lines in the key; none: a piece of the curve before it. Values that are not finite are gaps.
struct PanelCurve {
  std::vector<std::string> key;
  std::vector<double> x, y;
  std::string stroke;
};

/// A marked point.
struct PanelMark {
  double x = 0, y = 0;
  std::string colour;
  std::string text;  ///< next to it; may be empty
};

/// The area between two curves, below all lines; beyond the panel it is cut off.
struct PanelArea {
  std::vector<double> x, low, high;
  std::string colour;
};

/// A curve whose x may turn back: pieces in which it rises or falls, with ascending x; the first has the key.
[[nodiscard]] std::vector<PanelCurve> turning_curve(const std::vector<double>& x, const std::vector<double>& y,
                                                    const std::string& stroke, const std::string& key);

/// A panel with its curves.
struct PanelRow {
  Axis x, y;
  std::vector<PanelCurve> curves;
  std::vector<PanelMark> marks;
  std::vector<double> levels = {};                     ///< thin horizontal lines
  std::vector<std::pair<double, double>> shaded = {};  ///< ranges (from, to) along x
  std::string title = {};                              ///< above it, next to other panels
  std::vector<PanelArea> areas = {};
};

/// The part of a curve inside its panel, thinned to what is visible (extremes remain).
/// @param x  ascending
[[nodiscard]] std::vector<std::vector<PixelPoint>> visible_pieces(const PlotPanel& panel, const std::vector<double>& x,
                                                                  const std::vector<double>& y);

void draw_row(SvgCanvas& canvas, const PlotPanel& panel, const PanelRow& row);

/// A logarithmic axis over the finite values of curves, down to `depth` times the largest at most.
[[nodiscard]] Axis logarithmic_axis(const std::vector<PanelCurve>& curves, double depth, std::string label);

/// A linear axis with some space at the ends; an end at 0 stays at 0.
[[nodiscard]] Axis airy_axis(double from, double to, std::string label);

/// Draws marked points, with texts beside them of which none lies over another one or over another mark, nor, if there
/// is room, over one of the lines: above, below or beside, inside the frame if there is room. A text without any room
/// is left out.
void draw_panel_marks(SvgCanvas& canvas, const PlotPanel& panel, const std::vector<PanelMark>& marks,
                      const std::vector<std::vector<PixelPoint>>& lines = {});

}  // namespace trivet::report
