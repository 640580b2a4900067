// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/report/drawing/band_steps.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/curve_panel.h"
#include "trivet/report/drawing/panel_figure.h"
#include "trivet/report/drawing/result_figures.h"

namespace trivet::report {
namespace {

constexpr double invisible_limit = 1e-4;  // of the highest of level and limit

/// Level of the channel as its line defines it (rms or amplitude), from the margin.
std::vector<double> levels(const study::LimitLineResult& found, double factor) {
  std::vector<double> result;
  for (std::size_t i = 0; i < found.comparison.angular_frequency.size(); ++i) {
    const double margin = found.comparison.margin(to_index(i));
    const double limit = response::zero_to_peak_limit(found.line, found.comparison.angular_frequency[i]) *
        (found.line.rms ? std::sqrt(0.5) : 1);
    result.push_back(margin > 0 && std::isfinite(margin) ? factor * limit / margin
                                                         : std::numeric_limits<double>::quiet_NaN());
  }
  const std::vector<double>& omega = found.comparison.angular_frequency;
  for (std::size_t i = 1; i < result.size();
       ++i)  // at a step of the line there are two margins, but the lower limit belongs to one of them
    if (omega[i] == omega[i - 1]) result[i - 1] = result[i] = std::max(result[i - 1], result[i]);
  return result;
}

/// Word for the level of the axis.
std::string level_of(const assembly::LimitLine& line, const project::DisplayUnits& display) {
  return line.rms ? "rms" : results::level_words(project::shown_level(display, line.unit));
}

PanelRow limit_row(const study::LimitLineResult& found, const project::DisplayUnits& display) {
  const response::LimitComparison& comparison = found.comparison;
  const auto in_unit = [&](double omega) { return results::shown_frequency(display, omega); };
  const results::DisplayUnit shown = found.line.rms ? results::display_unit(display, found.line.unit)
                                                    : results::amplitude_unit(display, found.line.unit);
  const UnitPrefix unit = unit_prefix(std::ranges::max(found.line.limit), shown);
  PanelRow row;
  PanelCurve limit{{found.line.name.empty() ? "limit" : found.line.name},
                   {},
                   {},
                   "stroke=\"#b00020\" stroke-width=\"2\" stroke-dasharray=\"10,4\""};
  for (std::size_t i = 0; i < found.line.limit.size(); ++i) {
    limit.x.push_back(in_unit(found.line.angular_frequency[i]));
    limit.y.push_back(found.line.limit[i] * unit.factor);
  }
  PanelCurve level{{found.of}, {}, levels(found, unit.factor), series_stroke(0)};
  for (const double omega : comparison.angular_frequency) level.x.push_back(in_unit(omega));
  if (!found.bands.empty()) {
    set_steps(limit, found.bands, limits_in_bands(found, unit.factor), display);
    set_steps(level, found.bands, level.y, display);
  }
  if (std::isfinite(comparison.least_margin))
    level.key.push_back(fmt::format("least margin {:+.2f} dB", response::margin_level(comparison.least_margin)));
  if (std::isfinite(comparison.least_margin))
    level.key.push_back(
        fmt::format("at {:.4g} {}", in_unit(comparison.least_margin_at), results::frequency_unit(display)));
  if (comparison.least_margin > 0 && std::isfinite(comparison.least_margin)) {
    const double lowest =
        response::zero_to_peak_limit(found.line, comparison.least_margin_at) * (found.line.rms ? std::sqrt(0.5) : 1);
    row.marks.push_back({in_unit(comparison.least_margin_at), unit.factor * lowest / comparison.least_margin,
                         series_colour(0), fmt::format("{:+.2f} dB", response::margin_level(comparison.least_margin))});
  }
  for (const assembly::Band& band : comparison.exceeded) row.shaded.emplace_back(in_unit(band.from), in_unit(band.to));
  row.curves = {std::move(limit), std::move(level)};
  row.x = {std::max(in_unit(comparison.compared.from), 1e-4 * in_unit(comparison.compared.to)),
           in_unit(comparison.compared.to), true, results::frequency_heading(display)};
  row.y = logarithmic_axis(
      row.curves, invisible_limit,
      fmt::format("{}, {} [{}]", quantity_name(found.line.unit), level_of(found.line, display), unit.unit));
  return row;
}

}  // namespace

std::vector<double> limits_in_bands(const study::LimitLineResult& found, double factor) {
  std::vector<double> limits;
  for (std::size_t b = 0; b < found.bands.size(); ++b)
    limits.push_back(factor * std::sqrt(0.5) *
                     response::zero_to_peak_limit(found.line, found.comparison.angular_frequency[b]));
  return limits;
}

std::vector<Figure> limit_figures(const study::CaseResults& results) {
  std::vector<Figure> figures;
  for (const study::LimitLineResult& found : results.limit_lines) {
    if (found.comparison.angular_frequency.size() < (found.bands.empty() ? 2U : 1U)) continue;
    const std::string title =
        case_title(found.of + " and its limit" + (found.line.name.empty() ? "" : " " + found.line.name), results);
    figures.push_back(
        panel_figure(title, "limit-" + file_part(found.of) + ".svg", {limit_row(found, results.display)}));
  }
  return figures;
}

}  // namespace trivet::report
