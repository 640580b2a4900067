// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/figures/residual_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/report/drawing/plot_panel.h"

namespace trivet::report {
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

}  // namespace trivet::report
