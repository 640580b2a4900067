// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/documents/shown_numbers.h"
#include "trivet/foundation/index.h"
#include "trivet/nonlinear/modes/backbone.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/curve_panel.h"
#include "trivet/report/drawing/in_documents.h"
#include "trivet/report/drawing/panel_figure.h"
#include "trivet/report/drawing/result_figures.h"

/// Nonlinear modes.
namespace trivet::report {
namespace {

using nonlinear::Backbone;
using nonlinear::BackbonePoint;

constexpr std::size_t most_mode_figures = 24;

const std::vector<Backbone>* modes_in(const study::CaseResults& results) {
  const auto& modes = results.backbone;
  return modes && !modes->empty() ? &*modes : nullptr;
}

double half_of_range(const BackbonePoint& point, std::size_t result) { return point.results[result].half_of_range(); }

/// Rows of one result: its range over frequency and, if there is one, the damping ratio over its range.
std::vector<PanelRow> mode_rows(const std::vector<Backbone>& modes, std::size_t result,
                                const project::DisplayUnits& display, double largest) {
  const UnitPrefix unit = unit_prefix(largest, results::display_unit(display, modes.front().units[result]));
  PanelRow ranges, damping;
  double low = 0, high = 0, highest_ratio = 0;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    std::vector<double> frequency, range, ratio;
    for (const BackbonePoint& point : modes[m].points) {
      frequency.push_back(results::shown_frequency(display, point.angular_frequency));
      range.push_back(unit.factor * half_of_range(point, result));
      ratio.push_back(point.damping_ratio);
      low = low > 0 ? std::min(low, frequency.back()) : frequency.back();
      high = std::max(high, frequency.back());
      highest_ratio = std::max(highest_ratio, ratio.back());
    }
    const std::string stroke = fmt::format("stroke=\"{}\" stroke-width=\"2\"", series_colour(m)),
                      key = fmt::format("mode {}", modes[m].mode + 1);
    for (PanelCurve& piece : turning_curve(frequency, range, stroke, key)) ranges.curves.push_back(std::move(piece));
    for (PanelCurve& piece : turning_curve(range, ratio, stroke, key)) damping.curves.push_back(std::move(piece));
  }
  constexpr double margin = 0.05;
  const double space = std::max(margin * (high - low), margin * margin * high);
  ranges.x = {low - space, high + space, false, results::frequency_heading(display)};
  ranges.y = airy_axis(0, unit.factor * largest, "half the peak-to-peak value [" + unit.unit + "]");
  std::vector<PanelRow> rows = {std::move(ranges)};
  if (highest_ratio > 0) {
    damping.x = {0, unit.factor * largest, false, "half the peak-to-peak value [" + unit.unit + "]"};
    damping.y = airy_axis(0, highest_ratio, "damping ratio");
    rows.push_back(std::move(damping));
  }
  return rows;
}

}  // namespace

std::vector<Figure> backbone_figures(const study::CaseResults& results) {
  const std::vector<Backbone>* modes = modes_in(results);
  if (!modes) return {};
  std::vector<Figure> figures;
  const Backbone& first = modes->front();
  for (std::size_t c = 0; c < first.results.size() && figures.size() < most_mode_figures; ++c) {
    double largest = 0, of_unit = 0;
    for (const Backbone& mode : *modes)
      for (const BackbonePoint& point : mode.points) {
        largest = std::max(largest, half_of_range(point, c));
        for (std::size_t i = 0; i < first.results.size(); ++i)
          if (first.units[i] == first.units[c]) of_unit = std::max(of_unit, half_of_range(point, i));
      }
    constexpr double invisible = 1e-6;  // of the largest of its unit
    if (!(largest > invisible * of_unit)) continue;
    figures.push_back(panel_figure(case_title("Nonlinear modes in " + first.results[c], results),
                                   "backbone-" + file_part(first.results[c]) + ".svg",
                                   mode_rows(*modes, c, results.display, largest)));
  }
  return figures;
}

}  // namespace trivet::report
