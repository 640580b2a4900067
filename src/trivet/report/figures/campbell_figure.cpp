// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trivet/foundation/constants.h"
#include "trivet/report/drawing/plot_panel.h"
#include "trivet/report/drawing/result_figures.h"
#include "trivet/study/analyses/analysis_results.h"

namespace trivet::report {
namespace {

using foundation::rpm_per_rad_s;
using foundation::two_pi;
constexpr const char* wide_halo =
    "paint-order=\"stroke\" stroke=\"white\" stroke-width=\"4\" stroke-linejoin=\"round\"";

/// Upper end of the frequency axis: that of the orders or of the natural frequencies, whichever is lower.
double top_hertz(const response::Campbell& campbell) {
  const double orders = campbell.orders.back() * campbell.speed.to / two_pi;
  const double natural = campbell.natural.empty() ? orders : campbell.natural.back().angular_frequency / two_pi;
  return std::min(1.03 * orders, 1.25 * natural);
}

/// Horizontal lines with their names right of the panel, spread if the frequencies are close.
void draw_natural_frequencies(SvgCanvas& canvas, const PlotPanel& p, const response::Campbell& campbell) {
  constexpr double line_height = 13;
  const double right = p.corner.x + p.width;
  double last = p.corner.y + p.height + line_height;
  for (const response::NaturalLine& line : campbell.natural) {
    const double hertz = line.angular_frequency / two_pi;
    if (hertz > p.y.to) break;
    const double y = p.at(p.x.from, hertz).y, at = std::min(y, last - line_height);
    canvas.line({p.corner.x, y}, {right, y}, "stroke=\"#555\" stroke-width=\"1\" stroke-dasharray=\"6,3\"");
    if (at < p.corner.y - line_height) continue;  // no room for more names
    canvas.polyline({{right, y}, {right + 12, at}, {right + 16, at}}, "stroke=\"#999\" stroke-width=\"0.8\"");
    canvas.text(
        {right + 20, at + 4},
        fmt::format("{}{:.4g} Hz, ζ {:.2g}", line.nearest_mode ? fmt::format("mode {}: ", *line.nearest_mode) : "",
                    hertz, line.damping_ratio),
        "fill=\"#333\"");
    last = at;
  }
}

/// Oblique lines through the origin, named where they leave the panel.
void draw_orders(SvgCanvas& canvas, const PlotPanel& p, const response::Campbell& campbell) {
  double last_x = -1e9, last_y = -1e9;
  for (const double order : campbell.orders) {
    const double end = std::min(p.x.to, 60 * p.y.to / order);
    if (end <= p.x.from) continue;
    const PixelPoint to = p.at(end, order * end / 60);
    canvas.line(p.at(p.x.from, order * p.x.from / 60), to,
                fmt::format("stroke=\"{}\" stroke-width=\"1.4\"", series_colour(0)));
    const bool leaves_above = end < p.x.to;
    const PixelPoint at = leaves_above ? PixelPoint{to.x, p.corner.y - 5} : PixelPoint{to.x - 5, to.y - 4};
    if (std::abs(at.x - last_x) < 22 && std::abs(at.y - last_y) < 11) continue;
    canvas.text(at, fmt::format("{:g}", order),
                fmt::format("text-anchor=\"{}\" font-weight=\"bold\" fill=\"{}\" {}", leaves_above ? "middle" : "end",
                            series_colour(0), wide_halo));
    last_x = at.x;
    last_y = at.y;
  }
}

void draw_points(SvgCanvas& canvas, const PlotPanel& p, const response::Campbell& campbell) {
  for (const response::Interference& point : campbell.points)
    if (point.angular_frequency / two_pi <= p.y.to)
      canvas.circle(p.at(point.speed * rpm_per_rad_s, point.angular_frequency / two_pi), 4,
                    fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.3\"",
                                point.excited ? series_colour(1) : "white", series_colour(1)));
}

void draw_campbell_key(SvgCanvas& canvas, PixelPoint at) {
  canvas.line(at, {at.x + 22, at.y}, fmt::format("stroke=\"{}\" stroke-width=\"1.4\"", series_colour(0)));
  canvas.text({at.x + 27, at.y + 4}, "order", "");
  canvas.line({at.x + 68, at.y}, {at.x + 90, at.y}, "stroke=\"#555\" stroke-width=\"1\" stroke-dasharray=\"6,3\"");
  canvas.text({at.x + 95, at.y + 4}, "natural frequency", "");
  canvas.circle({at.x + 204, at.y}, 4, fmt::format("fill=\"{0}\" stroke=\"{0}\"", series_colour(1)));
  canvas.text({at.x + 212, at.y + 4}, "interference, excited", "");
  canvas.circle({at.x + 334, at.y}, 4,
                fmt::format("fill=\"white\" stroke=\"{}\" stroke-width=\"1.3\"", series_colour(1)));
  canvas.text({at.x + 342, at.y + 4}, "not excited", "");
}

}  // namespace

std::vector<Figure> campbell_figures(const study::CaseResults& results) {
  const auto& orders = results.orders;
  if (!orders || orders->campbell.orders.empty()) return {};
  const response::Campbell& campbell = orders->campbell;
  const PlotPanel panel{
      {58, 58},
      half_figure_width - 58 - 172,
      244,
      {campbell.speed.from * rpm_per_rad_s, campbell.speed.to * rpm_per_rad_s, false, "shaft speed [rpm]"},
      {0, top_hertz(campbell), false, "frequency [Hz]"}};
  const std::string title = case_title("Campbell diagram", results);
  SvgCanvas canvas(half_figure_width, 372);
  canvas.text({half_figure_width / 2, 22}, title, "text-anchor=\"middle\" font-size=\"14\" font-weight=\"bold\"");
  draw_frame(canvas, panel);
  draw_natural_frequencies(canvas, panel, campbell);
  draw_orders(canvas, panel, campbell);
  draw_points(canvas, panel, campbell);
  draw_campbell_key(canvas, {20, 348});
  return {{title, "campbell-diagram.svg", canvas.svg(title), {}, 2}};
}

}  // namespace trivet::report
