// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/curve_panel.h"
#include "trivet/report/drawing/panel_figure.h"
#include "trivet/report/drawing/result_figures.h"
#include "trivet/study/analyses/analysis_results.h"

namespace trivet::report {
namespace {

constexpr double invisible_shock = 1e-4;  // of the largest acceleration

PanelRow spectrum_row(const study::ShockSpectrumResult& result, const project::DisplayUnits& display) {
  double largest = 0;
  for (const excitation::ShockResponse& r : result.spectrum) largest = std::max(largest, r.maximax());
  const UnitPrefix unit = unit_prefix(largest, results::display_unit(display, result.unit));
  std::vector<double> hertz, up, down, after;
  for (const excitation::ShockResponse& r : result.spectrum) {
    hertz.push_back(results::shown_frequency(display, r.angular_frequency));
    up.push_back(r.largest() * unit.factor);
    down.push_back(-r.smallest() * unit.factor);
    after.push_back(r.residual() * unit.factor);
  }
  PanelRow row;
  row.x = {hertz.front(), hertz.back(), true,
           fmt::format("natural frequency [{}], damping ratio {:.4g}", results::frequency_unit(display),
                       result.damping_ratio)};
  row.curves = {{{"positive maximax"}, hertz, up, series_stroke(0)},
                {{"negative maximax"}, hertz, down, series_stroke(1)},
                {{"residual: after the shock,", "either sign"}, hertz, after, series_stroke(2)}};
  const auto top =
      std::ranges::max_element(result.spectrum, [](const auto& a, const auto& b) { return a.maximax() < b.maximax(); });
  row.marks = {{results::shown_frequency(display, top->angular_frequency), top->maximax() * unit.factor,
                series_colour(top->largest() >= -top->smallest() ? 0 : 1),
                fmt::format("{:.4g} {}", top->maximax() * unit.factor, unit.unit)}};
  row.y = logarithmic_axis(row.curves, invisible_shock,
                           fmt::format("absolute {} [{}]", quantity_name(result.unit), unit.unit));
  return row;
}

}  // namespace

std::vector<Figure> shock_figures(const study::CaseResults& results) {
  std::vector<Figure> figures;
  const auto& spectra = results.shock_spectrum;
  if (!spectra) return figures;
  for (const study::ShockSpectrumResult& result : *spectra) {
    if (result.spectrum.size() < 2) continue;
    const std::string title = case_title("Shock response spectrum: " + result.excitation, results);
    figures.push_back(
        panel_figure(title, "shock-" + file_part(result.excitation) + ".svg", {spectrum_row(result, results.display)}));
  }
  return figures;
}

}  // namespace trivet::report
