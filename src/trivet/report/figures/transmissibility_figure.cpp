// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/report/drawing/curve_panel.h"
#include "trivet/report/drawing/panel_figure.h"
#include "trivet/report/drawing/result_figures.h"
#include "trivet/study/analyses/analysis_results.h"

namespace trivet::report {
namespace {

constexpr double deepest = -80;  // dB

std::string isolation_words(const response::Crossover& crossover, const project::DisplayUnits& display) {
  if (!crossover.angular_frequency) return "does not isolate";
  return *crossover.angular_frequency == 0
      ? "isolates everywhere"
      : fmt::format("isolates above {:.4g} {}", results::shown_frequency(display, *crossover.angular_frequency),
                    results::frequency_unit(display));
}

}  // namespace

std::vector<Figure> transmissibility_figures(const study::CaseResults& results) {
  const auto& found = results.transmissibility;
  if (!found || found->curves.angular_frequency.size() < 3) return {};
  const study::TransmissibilityResult& result = *found;
  PanelRow row;
  const auto in_unit = [&](double omega) { return results::shown_frequency(results.display, omega); };
  std::vector<double> hertz;
  for (const double omega : result.curves.angular_frequency) hertz.push_back(in_unit(omega));
  row.x = {hertz.front() > 0 ? hertz.front() : std::max(hertz[1], 1e-3 * hertz.back()), hertz.back(), true,
           results::frequency_heading(results.display)};
  double low = 0, high = 0;
  for (std::size_t i = 0; i < result.curves.curves.size(); ++i) {
    const response::Curve& c = result.curves.curves[i];
    PanelCurve curve{{c.name}, hertz, {}, series_stroke(i)};
    for (std::size_t k = 0; k < hertz.size(); ++k) {
      const double level = response::transmissibility_level(std::abs(c.value(to_index(k))));
      curve.y.push_back(level);
      if (hertz[k] < row.x.from || !std::isfinite(level)) continue;
      low = std::min(low, level);
      high = std::max(high, level);
    }
    for (const response::Crossover& crossover : result.crossovers) {
      if (crossover.name != c.name || result.is_share(i)) continue;
      curve.key.push_back(isolation_words(crossover, results.display));
      if (crossover.angular_frequency && in_unit(*crossover.angular_frequency) > row.x.from &&
          in_unit(*crossover.angular_frequency) < row.x.to)
        row.marks.push_back({in_unit(*crossover.angular_frequency), 0, series_colour(i), ""});
    }
    row.curves.push_back(std::move(curve));
  }
  row.y = {std::max(deepest, 10 * std::floor(low / 10 - 0.2)), 10 * std::ceil(high / 10 + 0.2), false,
           "transmissibility [dB]"};
  row.levels = {0};
  const std::string title = case_title("Transmissibility: " + result.words, results);
  return {panel_figure(title, "transmissibility-level.svg", {row})};
}

}  // namespace trivet::report
