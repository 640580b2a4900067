// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "trivet/report/answer_figures.h"
#include "trivet/report/curve_groups.h"
#include "trivet/report/curve_panel.h"
#include "trivet/study/shock_spectrum_answer.h"

namespace trivet::report {
namespace {

constexpr double invisible_shock = 1e-4;  // of the largest acceleration

PanelRow spectrum_row(const study::ShockSpectrumResult& answer) {
  double largest = 0;
  for (const excitation::ShockResponse& r : answer.spectrum) largest = std::max(largest, r.maximax());
  const UnitPrefix unit = unit_prefix(largest, answer.unit);
  std::vector<double> hertz, up, down, after;
  for (const excitation::ShockResponse& r : answer.spectrum) {
    hertz.push_back(r.angular_frequency / (2 * std::numbers::pi));
    up.push_back(r.largest() * unit.factor);
    down.push_back(-r.smallest() * unit.factor);
    after.push_back(r.residual() * unit.factor);
  }
  PanelRow row;
  row.x = {hertz.front(), hertz.back(), true,
           fmt::format("natural frequency [Hz], damping ratio {:.4g}", answer.damping_ratio)};
  row.curves = {{{"positive maximax"}, hertz, up, series_stroke(0)},
                {{"negative maximax"}, hertz, down, series_stroke(1)},
                {{"residual: after the shock,", "either sign"}, hertz, after, series_stroke(2)}};
  const auto top = std::max_element(answer.spectrum.begin(), answer.spectrum.end(),
                                    [](const auto& a, const auto& b) { return a.maximax() < b.maximax(); });
  row.marks = {{top->angular_frequency / (2 * std::numbers::pi), top->maximax() * unit.factor,
                series_colour(top->largest() >= -top->smallest() ? 0 : 1),
                fmt::format("{:.4g} {}", top->maximax() * unit.factor, unit.unit)}};
  row.y = logarithmic_axis(row.curves, invisible_shock,
                           fmt::format("absolute {} [{}]", quantity_name(answer.unit), unit.unit));
  return row;
}

}  // namespace

std::vector<Figure> shock_figures(const study::Answers& answers) {
  std::vector<Figure> figures;
  const auto* spectra = answers.find<std::vector<study::ShockSpectrumResult>>("shock_spectrum");
  if (!spectra) return figures;
  for (const study::ShockSpectrumResult& answer : *spectra) {
    if (answer.spectrum.size() < 2) continue;
    const std::string title = case_title("Shock response spectrum: " + answer.excitation, answers);
    figures.push_back(
        {title, "shock-" + file_part(answer.excitation) + ".svg", stacked_rows(title, {spectrum_row(answer)})});
  }
  return figures;
}

}  // namespace trivet::report
