// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/figures/front_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/report/drawing/axis_ticks.h"
#include "trivet/report/drawing/curve_panel.h"
#include "trivet/report/drawing/result_figures.h"

namespace trivet::report {
namespace {

constexpr double front_figure_width = 640, front_figure_height = 470, front_width = 500, front_height = 340;
constexpr PixelPoint front_corner = {100, 50};

constexpr std::size_t most_numbered = 25;  ///< points

struct ScaledObjective {
  UnitPrefix prefix;
  Axis axis;
};

/// The range of one objective, with the given design if that is within twice the range of the front.
ScaledObjective scaled_objective(const study::DesignFront& front, std::size_t i, bool with_given) {
  const study::FrontObjective& one = front.objectives[i];
  ScaledObjective result{unit_prefix(one.most, one.unit), {}};
  const double low = with_given ? std::min(one.least, one.given) : one.least;
  const double high = with_given ? std::max(one.most, one.given) : one.most;
  constexpr double air = 0.06;
  const double width = std::max(high - low, 1e-6 * high);
  result.axis.from = result.prefix.factor * std::max(0.0, low - air * width);
  result.axis.to = result.prefix.factor * (high + air * width);
  result.axis.label = fmt::format("largest {} [{}]", one.name, result.prefix.unit);
  return result;
}

bool is_near_front(const study::FrontObjective& one) {
  const double width = one.most - one.least;
  return std::isfinite(one.given) && one.given <= one.most + width && one.given >= one.least - width;
}

}  // namespace

Figure front_figure(const study::DesignFront& front, const std::string& title) {
  const bool with_given = std::ranges::all_of(front.objectives, is_near_front);
  const ScaledObjective x = scaled_objective(front, 0, with_given), y = scaled_objective(front, 1, with_given);
  const PlotPanel panel{front_corner, front_width, front_height, x.axis, y.axis};
  const auto place = [&](double first, double second) {
    return panel.at(x.prefix.factor * first, y.prefix.factor * second);
  };
  SvgCanvas canvas(front_figure_width, front_figure_height);
  canvas.text({front_corner.x + front_width / 2, front_corner.y - 22}, title,
              "text-anchor=\"middle\" font-size=\"14\" font-weight=\"bold\"");
  draw_frame(canvas, panel);
  std::vector<PixelPoint> line;
  for (const study::FrontPoint& point : front.points) line.push_back(place(point.amplitudes[0], point.amplitudes[1]));
  canvas.line(line.front(), line.back(), "stroke=\"#777\" stroke-dasharray=\"6,4\"");
  canvas.polyline(line, fmt::format("stroke=\"{}\" stroke-width=\"1.6\"", series_colour(0)));
  for (std::size_t k = 0; k < line.size(); ++k) {
    const bool knee = front.knee == k;
    canvas.circle(line[k], knee ? 6 : 3.5, fmt::format("fill=\"{}\"", series_colour(knee ? 1 : 0)));
    if (!knee && line.size() > most_numbered && k % (line.size() / most_numbered + 1) != 0) continue;
    canvas.text({line[k].x + 8, line[k].y - 6}, knee ? fmt::format("{} knee", k + 1) : std::to_string(k + 1),
                knee ? "font-weight=\"bold\"" : "font-size=\"11\"");
  }
  if (with_given) {
    const PixelPoint given = place(front.objectives[0].given, front.objectives[1].given);
    canvas.circle(given, 4, "fill=\"none\" stroke=\"#333\" stroke-width=\"1.4\"");
    canvas.text({given.x, given.y + 17}, "given", "text-anchor=\"middle\"");
  }
  return {title, "front.svg", canvas.svg("front between two results")};
}

std::vector<Figure> front_figures(const study::CaseResults& results) {
  if (!results.front || results.front->objectives.size() != 2) return {};
  return {front_figure(*results.front, case_title("Front", results))};
}

}  // namespace trivet::report
