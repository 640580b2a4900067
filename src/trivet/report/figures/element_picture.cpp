// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/figures/element_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "trivet/documents/shown_numbers.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/curve_panel.h"
#include "trivet/report/drawing/in_documents.h"
#include "trivet/report/drawing/panel_figure.h"
#include "trivet/report/drawing/plot_panel.h"
#include "trivet/report/figures/stiffness_plots.h"

namespace trivet::report {

using nonlinear::AmplitudeStiffness;

void draw_amplitude_stiffness(SvgCanvas& canvas, PixelPoint corner, const std::vector<AmplitudeStiffness>& curves,
                              const project::DisplayUnits& display) {
  constexpr double left = 90, top = 40, width = 640, height = 210, between = 60;
  double largest = 0, from = foundation::infinity, to = 0;
  for (const AmplitudeStiffness& one : curves) {
    if (one.angular_frequency.empty()) continue;
    largest = std::max(largest, one.stiffness.cwiseAbs().maxCoeff());
    const auto [low, high] = std::ranges::minmax_element(one.angular_frequency);
    from = std::min(from, *low / foundation::two_pi);
    to = std::max(to, *high / foundation::two_pi);
  }
  const UnitPrefix unit = unit_prefix(largest, results::display_unit(display, "N/m")),
                   length = unit_prefix(curves.back().amplitude, results::display_unit(display, "m"));
  PanelRow magnitude, angle;
  double lowest_angle = 0, highest_angle = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const AmplitudeStiffness& one = curves[i];
    const std::string stroke = fmt::format("stroke=\"{}\" stroke-width=\"1.8\"", series_colour(i));
    PanelCurve size{{fmt::format("± {:.4g} {}", length.factor * one.amplitude, length.unit)}, {}, {}, stroke},
        phase{{}, {}, {}, stroke};
    for (std::size_t p = 0; p < one.angular_frequency.size(); ++p) {
      const std::complex<double> value = one.stiffness(to_index(p));
      const double degrees = std::arg(value) * 360 / foundation::two_pi;
      size.x.push_back(one.angular_frequency[p] / foundation::two_pi);
      size.y.push_back(unit.factor * std::abs(value));
      phase.x.push_back(size.x.back());
      phase.y.push_back(degrees);
      lowest_angle = std::min(lowest_angle, degrees);
      highest_angle = std::max(highest_angle, degrees);
    }
    magnitude.curves.push_back(std::move(size));
    angle.curves.push_back(std::move(phase));
  }
  magnitude.x = angle.x = {from, to, true, "f [Hz]"};
  magnitude.y = airy_axis(0, unit.factor * largest, "|K| [" + unit.unit + "]");
  angle.y = airy_axis(lowest_angle, highest_angle, "loss angle [°]");
  canvas.text({corner.x + left, corner.y + 22},
              "Dynamic stiffness along z of end K, N held, by the amplitude of the deflection", "font-weight=\"bold\"");
  draw_row(canvas, {{corner.x + left, corner.y + top}, width, height, magnitude.x, magnitude.y}, magnitude);
  draw_row(canvas, {{corner.x + left, corner.y + top + height + between}, width, height, angle.x, angle.y}, angle);
  draw_key(canvas, {corner.x + left + width + 18, corner.y + top}, magnitude.curves);
}

void draw_law_loops(SvgCanvas& canvas, PixelPoint corner, const study::ElementLaws& laws,
                    const project::DisplayUnits& display) {
  constexpr double left = 90, top = 40, width = 640, height = 230;
  const bool turns = laws.turns;
  double low_x = 0, high_x = 0, low_y = 0, high_y = 0;
  for (const nonlinear::LawLoop& loop : laws.loops) {
    const auto [x_low, x_high] = std::ranges::minmax_element(loop.deflections);
    const auto [y_low, y_high] = std::ranges::minmax_element(loop.forces);
    low_x = std::min(low_x, *x_low);
    high_x = std::max(high_x, *x_high);
    low_y = std::min(low_y, *y_low);
    high_y = std::max(high_y, *y_high);
  }
  const UnitPrefix x_unit = unit_prefix(std::max(-low_x, high_x), results::display_unit(display, turns ? "rad" : "m")),
                   y_unit = unit_prefix(std::max(-low_y, high_y), results::display_unit(display, turns ? "N m" : "N"));
  PanelRow row;
  row.x = airy_axis(x_unit.factor * low_x, x_unit.factor * high_x, "deflection [" + x_unit.unit + "]");
  row.y = airy_axis(y_unit.factor * low_y, y_unit.factor * high_y,
                    (laws.whole ? "force [" : "force of the laws [") + y_unit.unit + "]");
  for (std::size_t i = laws.loops.size(); i-- > 0;) {
    const nonlinear::LawLoop& loop = laws.loops[i];
    const std::string stroke = fmt::format("stroke=\"{}\" stroke-width=\"1.8\"", series_colour(i));
    // Falling from the largest deflection, then rising to it: both with ascending x.
    const std::size_t half = loop.deflections.size() / 2;
    PanelCurve falling{{fmt::format("± {:.4g} {}", x_unit.factor * loop.amplitude, x_unit.unit)}, {}, {}, stroke},
        rising{{}, {}, {}, stroke};
    for (std::size_t s = 0; s < loop.deflections.size(); ++s) {
      PanelCurve& to = s < half ? falling : rising;
      to.x.push_back(x_unit.factor * loop.deflections[s]);
      to.y.push_back(y_unit.factor * loop.forces[s]);
    }
    falling.x.push_back(rising.x.front());
    falling.y.push_back(rising.y.front());
    std::ranges::reverse(falling.x);
    std::ranges::reverse(falling.y);
    row.curves.push_back(std::move(falling));
    row.curves.push_back(std::move(rising));
  }
  canvas.text({corner.x + left, corner.y + 22},
              fmt::format("Slow loops {}{}", laws.words, laws.whole ? "" : ", of the laws alone"),
              "font-weight=\"bold\"");
  draw_row(canvas, {{corner.x + left, corner.y + top}, width, height, row.x, row.y}, row);
  draw_key(canvas, {corner.x + left + width + 18, corner.y + top}, row.curves);
}

namespace {

constexpr double plot_height = 200, above = 34, axis_below = 44, line_height = 15;
constexpr std::size_t most_named = 8;
constexpr double usual = 2;  // standard deviations; 95 % of the readings are within

/// Indices of outliers, the farthest first.
std::vector<std::size_t> outliers(const std::vector<model::Residual>& residuals) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < residuals.size(); ++i)
    if (residuals[i].outlier && std::isfinite(residuals[i].standardised)) found.push_back(i);
  std::ranges::stable_sort(found, [&](std::size_t a, std::size_t b) {
    return std::abs(residuals[a].standardised) > std::abs(residuals[b].standardised);
  });
  return found;
}

std::size_t lines(std::size_t outlier_count) {
  return std::min(outlier_count, most_named) + (outlier_count > most_named ? 1 : 0);
}

double axis_limit(const std::vector<model::Residual>& residuals) {
  double largest = 3;
  for (const model::Residual& r : residuals)
    if (std::isfinite(r.standardised)) largest = std::max(largest, std::abs(r.standardised));
  return 1.12 * largest;
}

}  // namespace

double residual_plot_height(const std::vector<model::Residual>& residuals) {
  return above + plot_height + axis_below + line_height * static_cast<double>(lines(outliers(residuals).size()));
}

void draw_residuals(SvgCanvas& canvas, PixelPoint corner, const std::vector<model::Residual>& residuals) {
  const double top = axis_limit(residuals), count = static_cast<double>(residuals.size());
  const PlotPanel panel{{corner.x + 86, corner.y + above},
                        860,
                        plot_height,
                        {0, count + 1, false, "reading, in the order of the data"},
                        {-top, top, false, "residual / standard deviation"}};
  canvas.text({corner.x + 490, corner.y + above - 12}, "Readings compared with the fit",
              "text-anchor=\"middle\" font-size=\"13\" font-weight=\"bold\"");
  draw_frame(canvas, panel);
  canvas.line(panel.at(0, 0), panel.at(count + 1, 0), "stroke=\"#333\" stroke-width=\"0.8\"");
  for (const double limit : {-usual, usual})
    canvas.line(panel.at(0, limit), panel.at(count + 1, limit), "stroke=\"#777\" stroke-dasharray=\"6,4\"");
  for (std::size_t i = 0; i < residuals.size(); ++i)
    if (!residuals[i].outlier && std::isfinite(residuals[i].standardised))
      canvas.circle(panel.at(static_cast<double>(i + 1), residuals[i].standardised), 2.2,
                    fmt::format("fill=\"{}\"", series_colour(0)));
  const std::vector<std::size_t> marked = outliers(residuals);
  double y = corner.y + above + plot_height + axis_below + 6;
  for (std::size_t n = 0; n < marked.size(); ++n) {
    const model::Residual& r = residuals[marked[n]];
    const PixelPoint at = panel.at(static_cast<double>(marked[n] + 1), r.standardised);
    canvas.circle(at, 4, fmt::format("fill=\"{0}\" stroke=\"{0}\"", series_colour(1)));
    if (n >= most_named) continue;
    const bool at_right = at.x > corner.x + 900;
    canvas.text({at.x + (at_right ? -8 : 8), at.y + 4}, std::to_string(n + 1),
                fmt::format("text-anchor=\"{}\" font-weight=\"bold\" fill=\"{}\"", at_right ? "end" : "start",
                            series_colour(1)));
    canvas.text({corner.x + 86, y},
                fmt::format("outlier {}: {}, measured {:.5g}, fitted {:.5g}, {:+.1f} standard deviations", n + 1,
                            r.what, r.measured, r.fitted, r.standardised),
                "");
    y += line_height;
  }
  if (marked.size() > most_named)
    canvas.text({corner.x + 86, y}, fmt::format("and {} more outliers", marked.size() - most_named), "");
}

std::string element_picture(const project::Case& variant, std::size_t index) {
  constexpr double width = 980, title_height = 44, gap = 20;
  const model::Element& element = variant.system.elements()[index];
  const bool identified = element.evidence && !element.evidence->residuals.empty();
  const auto band = dynamic_band(element.law);
  const double residuals = identified ? residual_plot_height(element.evidence->residuals) + gap : 0;
  const double dynamics = band ? dynamic_stiffness_plot_height + gap : 0;
  std::vector<study::ElementLaws> laws = study::element_laws(variant, index);
  std::erase_if(laws, [](const study::ElementLaws& one) { return one.loops.empty(); });
  const double loops = static_cast<double>(laws.size()) * law_loop_plot_height;

  const std::vector<nonlinear::AmplitudeStiffness> over_amplitude = study::stiffness_over_amplitude(variant, index);
  const double amplitudes = over_amplitude.empty() ? 0 : amplitude_stiffness_plot_height;

  SvgCanvas canvas(width, title_height + stiffness_map_height + residuals + dynamics + amplitudes + loops);
  const std::string title = element.name + ", " + element.type + (variant.name.empty() ? "" : ", " + variant.name);
  canvas.text({width / 2, 24}, title, "text-anchor=\"middle\" font-size=\"15\" font-weight=\"bold\"");
  canvas.text({width / 2, 40}, "stiffness 12×12 in local axes", "text-anchor=\"middle\" fill=\"#333\"");
  draw_stiffness_map(canvas, {20, title_height}, elements::stiffness(element.law));
  double y = title_height + stiffness_map_height;
  if (identified) {
    draw_residuals(canvas, {0, y}, element.evidence->residuals);
    y += residuals;
  }
  if (band) draw_dynamic_stiffness(canvas, {0, y}, element.law, *band);
  y += dynamics;
  if (!over_amplitude.empty()) draw_amplitude_stiffness(canvas, {0, y}, over_amplitude, variant.display);
  y += amplitudes;
  for (const study::ElementLaws& one : laws) {
    draw_law_loops(canvas, {0, y}, one, variant.display);
    y += law_loop_plot_height;
  }
  return canvas.svg("Stiffness of element " + title);
}

}  // namespace trivet::report
