// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/report/drawing/axis_ticks.h"
#include "trivet/report/drawing/svg_canvas.h"

namespace trivet::report {

/// Range and label of one axis of a plot.
struct Axis {
  double from = 0, to = 1;
  bool logarithmic = false;
  std::string label;

  /// Position of a value: 0 at `from`, 1 at `to`, extrapolated beyond; a logarithmic axis needs values > 0.
  [[nodiscard]] double position(double value) const;
  /// Position of a value: 0 at `from`, 1 at `to`, limited to this range.
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

/// Distance from the frame to the middle of the label of the y axis, outside the labels of its ticks.
[[nodiscard]] double y_title_distance(const PlotPanel& panel);

/// Draws grid, ticks with their labels, frame and axis labels.
void draw_frame(SvgCanvas& canvas, const PlotPanel& panel);

/// Colour of a curve (Okabe–Ito, which colour-blind readers can distinguish) and its dash for grey print: lengths of
/// strokes and gaps [pixels], none if it is not dashed. Figures and the page's charts use the same.
struct SeriesStyle {
  const char* colour;
  std::vector<int> dash;
};
inline constexpr std::size_t different_strokes = 36;  ///< after these they repeat
[[nodiscard]] SeriesStyle series_style(std::size_t series);
[[nodiscard]] const char* series_colour(std::size_t series);
/// The same as attributes of an SVG element.
[[nodiscard]] std::string series_stroke(std::size_t series);

}  // namespace trivet::report
