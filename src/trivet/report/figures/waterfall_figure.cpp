// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/plot_panel.h"
#include "trivet/report/drawing/result_figures.h"
#include "trivet/study/analyses/analysis_results.h"

namespace trivet::report {
namespace {

using foundation::rpm_per_rad_s;
using foundation::two_pi;
constexpr int spectra = 41;

/// The curve with the highest rms among those with the unit of the first curve that is not zero.
std::optional<std::size_t> tallest_curve(const response::RunUp& run_up) {
  std::optional<std::size_t> best;
  for (std::size_t c = 0; c < run_up.overall.size(); ++c) {
    const double height = highest_finite(run_up.overall[c].rms);
    if (height > 0 &&
        (!best ||
         (run_up.overall[c].unit == run_up.overall[*best].unit && height > highest_finite(run_up.overall[*best].rms))))
      best = c;
  }
  return best;
}

/// Projection: frequency to the right, shaft speed to the back (up and to the right), amplitude upwards.
struct Space {
  PixelPoint origin{58, 322};
  double width = 254, height = 120;
  PixelPoint back{96, -160};
  double hertz_to, rpm_from, rpm_to, amplitude_to;

  PixelPoint at(double hertz, double rpm, double amplitude) const {
    const double depth = (rpm - rpm_from) / (rpm_to - rpm_from);
    return {origin.x + width * hertz / hertz_to + back.x * depth,
            origin.y + back.y * depth - height * amplitude / amplitude_to};
  }
};

void draw_axes(SvgCanvas& canvas, const Space& s, const std::string& quantity) {
  for (const Tick& tick : linear_ticks(0, s.hertz_to, 5)) {
    const PixelPoint front = s.at(tick.value, s.rpm_from, 0);
    canvas.line(front, s.at(tick.value, s.rpm_to, 0), "stroke=\"#e4e4e4\"");
    canvas.line(front, {front.x, front.y + 5}, "stroke=\"#333\"");
    canvas.text({front.x, front.y + 18}, tick.label, "text-anchor=\"middle\" fill=\"#333\"");
  }
  canvas.text({s.origin.x + s.width / 2, s.origin.y + 36}, "frequency [Hz]", "text-anchor=\"middle\"");
  for (const Tick& tick : linear_ticks(s.rpm_from, s.rpm_to, 6)) {
    const PixelPoint right = s.at(s.hertz_to, tick.value, 0);
    canvas.line(right, {right.x + 5, right.y}, "stroke=\"#333\"");
    canvas.text({right.x + 9, right.y + 4}, tick.label, "fill=\"#333\"");
  }
  const PixelPoint middle = s.at(s.hertz_to, (s.rpm_from + s.rpm_to) / 2, 0);
  const double x_name = middle.x + 56, y_name = middle.y + 22, slope = std::atan2(s.back.y, s.back.x) * 360 / two_pi;
  canvas.text({x_name, y_name}, "shaft speed [rpm]",
              fmt::format("text-anchor=\"middle\" transform=\"rotate({:.1f} {:.2f} {:.2f})\"", slope, x_name, y_name));
  for (const Tick& tick : linear_ticks(0, s.amplitude_to, 4)) {
    const PixelPoint on_axis = s.at(0, s.rpm_from, tick.value);
    canvas.line({on_axis.x - 5, on_axis.y}, on_axis, "stroke=\"#333\"");
    canvas.text({on_axis.x - 8, on_axis.y + 4}, tick.label, "text-anchor=\"end\" fill=\"#333\"");
  }
  for (const auto& [a, b] : {std::pair{s.at(0, s.rpm_from, 0), s.at(s.hertz_to, s.rpm_from, 0)},
                             std::pair{s.at(s.hertz_to, s.rpm_from, 0), s.at(s.hertz_to, s.rpm_to, 0)},
                             std::pair{s.at(0, s.rpm_from, 0), s.at(0, s.rpm_from, s.amplitude_to)}})
    canvas.line(a, b, "stroke=\"#333\"");
  const double x = s.origin.x - 44, y = s.origin.y - s.height / 2;
  canvas.text({x, y}, quantity, fmt::format("text-anchor=\"middle\" transform=\"rotate(-90 {:.2f} {:.2f})\"", x, y));
}

/// Draws the spectra, the farthest first; lines of one order have one colour.
void draw_spectra(SvgCanvas& canvas, const Space& s, const std::vector<response::WaterfallLine>& lines,
                  const std::vector<double>& orders, double factor) {
  for (std::size_t i = lines.size(); i-- > 0;) {
    const response::WaterfallLine& line = lines[i];
    const double rpm = line.speed * rpm_per_rad_s, hertz = line.angular_frequency / two_pi;
    if (i + 1 == lines.size() || lines[i + 1].speed != line.speed)
      canvas.line(s.at(0, rpm, 0), s.at(s.hertz_to, rpm, 0), "stroke=\"#b8b8b8\" stroke-width=\"0.8\"");
    if (hertz > s.hertz_to || !std::isfinite(line.amplitude)) continue;
    const auto order = to_size(std::ranges::find(orders, line.order) - orders.begin());
    canvas.line(s.at(hertz, rpm, 0), s.at(hertz, rpm, line.amplitude * factor),
                fmt::format("stroke=\"{}\" stroke-width=\"2\"", series_colour(order)));
  }
  for (std::size_t k = 0; k < orders.size(); ++k) {
    const double rpm = std::min(s.rpm_to, 60 * s.hertz_to / orders[k]);
    if (rpm <= s.rpm_from) continue;
    canvas.line(s.at(orders[k] * s.rpm_from / 60, s.rpm_from, 0), s.at(orders[k] * rpm / 60, rpm, 0),
                fmt::format("stroke=\"{}\" stroke-width=\"0.8\" stroke-dasharray=\"2,3\"", series_colour(k)));
  }
}

}  // namespace

std::vector<Figure> waterfall_figures(const study::CaseResults& results) {
  const auto& found = results.orders;
  if (!found || found->run_up.speed.size() < 2) return {};
  const response::RunUp& run_up = found->run_up;
  const std::optional<std::size_t> curve = tallest_curve(run_up);
  if (!curve) return {};
  const std::vector<response::WaterfallLine> lines = response::waterfall(run_up, *curve, spectra);
  double largest = 0;
  std::map<double, double> by_order;
  for (const response::WaterfallLine& line : lines)
    if (std::isfinite(line.amplitude)) {
      largest = std::max(largest, line.amplitude);
      by_order[line.order] = std::max(by_order[line.order], line.amplitude);
    }
  if (!(largest > 0)) return {};
  std::vector<double> orders;
  for (const auto& [order, amplitude] : by_order)
    if (amplitude > 1e-3 * largest) orders.push_back(order);
  project::DisplayUnits rms = results.display;
  rms.level = project::Level::rms;  // as everywhere in a run-up
  const UnitPrefix unit = unit_prefix(largest, results::amplitude_unit(rms, run_up.overall[*curve].unit));
  Space space;
  space.rpm_from = run_up.speed.front() * rpm_per_rad_s;
  space.rpm_to = run_up.speed.back() * rpm_per_rad_s;
  space.hertz_to =
      orders.front() * run_up.speed.back() / two_pi;  // the whole lowest order, and the visible part of the others
  for (const response::WaterfallLine& line : lines)
    if (line.amplitude > 0.01 * largest) space.hertz_to = std::max(space.hertz_to, line.angular_frequency / two_pi);
  space.amplitude_to = largest * unit.factor;
  std::vector<response::WaterfallLine> visible;
  std::ranges::copy_if(lines, std::back_inserter(visible),
                       [&](const auto& line) { return by_order[line.order] > 1e-3 * largest; });

  const std::string title = case_title("Waterfall: " + run_up.overall[*curve].name, results);
  SvgCanvas canvas(half_figure_width, 372);
  canvas.text({half_figure_width / 2, 22}, title, "text-anchor=\"middle\" font-size=\"14\" font-weight=\"bold\"");
  draw_axes(canvas, space, fmt::format("{} amplitude [{}]", quantity_name(run_up.overall[*curve].unit), unit.unit));
  draw_spectra(canvas, space, visible, orders, unit.factor);
  for (std::size_t k = 0; k < orders.size(); ++k) {
    const double y = 60 + 17 * static_cast<double>(k);
    canvas.line({60, y}, {84, y}, fmt::format("stroke=\"{}\" stroke-width=\"3\"", series_colour(k)));
    canvas.text({91, y + 4}, fmt::format("order {:g}", orders[k]), "");
  }
  return {{title, "waterfall-" + file_part(run_up.overall[*curve].name) + ".svg", canvas.svg(title), {}, 2}};
}

}  // namespace trivet::report
