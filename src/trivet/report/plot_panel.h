// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/report/axis_ticks.h"
#include "trivet/report/svg_canvas.h"

namespace trivet::report {

/// What one axis of a plot covers.
struct Axis {
  double from = 0, to = 1;
  bool logarithmic = false;
  std::string label;

  /// 0 at `from`, 1 at `to`, also beyond; a logarithmic axis takes values > 0.
  [[nodiscard]] double position(double value) const;
  /// 0 at `from`, 1 at `to`; values beyond stay at the edge.
  [[nodiscard]] double share(double value) const;
  [[nodiscard]] std::vector<Tick> ticks(int wanted) const;
};

/// A framed plot on a canvas [pixels].
struct PlotPanel {
  PixelPoint corner;
  double width = 400, height = 200;
  Axis x, y;

  [[nodiscard]] PixelPoint at(double x_value, double y_value) const;
};

/// From the frame to the middle of the label of the y axis: beyond the labels of its ticks.
[[nodiscard]] double y_title_distance(const PlotPanel& panel);

/// Grid, ticks with their labels, frame and axis labels.
void draw_frame(SvgCanvas& canvas, const PlotPanel& panel);

/// Okabe–Ito colours, told apart by colour-blind readers.
[[nodiscard]] const char* series_colour(std::size_t series);
/// Stroke of a curve: its colour, and a dash for grey print; 36 differ.
[[nodiscard]] std::string series_stroke(std::size_t series);

}  // namespace trivet::report
