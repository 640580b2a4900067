// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "trivet/foundation/constants.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/curve_panel.h"
#include "trivet/report/drawing/panel_figure.h"
#include "trivet/report/drawing/result_figures.h"
#include "trivet/study/analyses/analysis_results.h"

namespace trivet::report {
namespace {

using foundation::two_pi;
constexpr double invisible_random = 1e-8;  // of the largest density

std::string rms_words(const response::RandomChannel& channel, const project::DisplayUnits& display) {
  if (channel.vanishes) return "≈ 0";
  if (!channel.rms) return channel.infinite_rms ? "rms infinite" : "no rms";
  const UnitPrefix unit = unit_prefix(*channel.rms, results::display_unit(display, channel.unit));
  return fmt::format("{:.4g} {} rms", *channel.rms * unit.factor, unit.unit);
}

PanelRow density_row(const study::RandomResult& random, const std::vector<GroupedCurve>& series,
                     const project::DisplayUnits& display) {
  const auto& results = random.response.channels;
  double largest = 0;
  for (const GroupedCurve& s : series) largest = std::max(largest, results[s.curve].rms.value_or(0));
  const std::string& si = results[series.front().curve].unit;
  const UnitPrefix unit =
      unit_prefix(10 * largest, results::display_unit(display, si));  // (m/s²)²/Hz from 0.1 m/s² rms
  PanelRow row;
  std::vector<double> frequency;
  for (const double omega : random.curves.angular_frequency)
    frequency.push_back(results::shown_frequency(display, omega));
  for (std::size_t i = 0; i < series.size(); ++i) {
    const response::RandomChannel& channel = results[series[i].curve];
    PanelCurve curve{{series[i].label + ": " + rms_words(channel, display)}, frequency, {}, series_stroke(i)};
    if (!channel.vanishes)
      for (const double density : random.curves.density[series[i].curve])
        curve.y.push_back(two_pi * unit.factor * unit.factor * density);
    row.curves.push_back(std::move(curve));
  }
  row.x = {frequency.front() > 0 ? frequency.front() : std::max(frequency[1], 1e-4 * frequency.back()),
           frequency.back(), true, results::frequency_heading(display)};
  row.y = logarithmic_axis(row.curves, invisible_random,
                           fmt::format("{} density [{}]", quantity_name(si), density_unit(unit.unit)));
  return row;
}

}  // namespace

std::vector<Figure> random_figures(const study::CaseResults& results) {
  std::vector<Figure> figures;
  const auto& random = results.random;
  if (!random || random->curves.angular_frequency.size() < 3) return figures;
  for (const CurveGroup& group : curve_groups(curve_names(random->response.channels))) {
    std::vector<PanelRow> rows;
    for (const auto* series : {&group.upper, &group.lower})
      if (!series->empty()) rows.push_back(density_row(*random, *series, results.display));
    const std::string title = case_title("Power spectral density: " + group.name, results);
    figures.push_back(panel_figure(title, "random-" + file_part(group.name) + ".svg", rows));
  }
  return figures;
}

}  // namespace trivet::report
