// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "trivet/report/drawing/band_steps.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/panel_figure.h"
#include "trivet/report/drawing/result_figures.h"
#include "trivet/response/machinery/limit_line.h"
#include "trivet/results/model/band_levels.h"

/// The measured levels of excitations, as a floor has them, with the limits in the same bands.
namespace trivet::report {
namespace {

constexpr double invisible_level = 1e-4;  // of the highest level or limit

struct Measured {
  std::string excitation;
  results::BandLevels levels;
};

bool is_comparable(const results::BandLevels& a, const results::BandLevels& b) {
  return a.unit == b.unit && a.width == b.width;
}

/// Excitations with levels that one chart can show.
std::vector<std::vector<Measured>> groups_of(const model::Description& machine) {
  std::vector<std::vector<Measured>> groups;
  for (const model::Excitation& excitation : machine.excitations) {
    std::optional<results::BandLevels> levels = results::band_levels(excitation);
    if (!levels) continue;
    const auto same =
        std::ranges::find_if(groups, [&](const auto& group) { return is_comparable(group.front().levels, *levels); });
    auto& group = same == groups.end() ? groups.emplace_back() : *same;
    group.push_back({excitation.name, *std::move(levels)});
  }
  return groups;
}

/// Limit lines in the same bands and the same quantity; equal ones are one line with the names of all.
std::vector<PanelCurve> limits_of(const study::CaseResults& results, const results::BandLevels& levels, double factor) {
  std::vector<PanelCurve> curves;
  for (const study::LimitLineResult& found : results.limit_lines) {
    if (found.bands.empty() || found.bands.front().width != levels.width || found.line.unit != levels.unit) continue;
    PanelCurve curve{{}, {}, {}, "stroke=\"#b00020\" stroke-width=\"2\" stroke-dasharray=\"10,4\""};
    set_steps(curve, found.bands, limits_in_bands(found, factor), results.display);
    const auto same =
        std::ranges::find_if(curves, [&](const PanelCurve& other) { return other.x == curve.x && other.y == curve.y; });
    PanelCurve& shown = same == curves.end() ? curves.emplace_back(std::move(curve)) : *same;
    if (shown.key.empty()) shown.key.push_back("limit of:");
    shown.key.push_back(found.of);
  }
  return curves;
}

double overall(const std::vector<double>& levels) {
  double square = 0;
  for (const double level : levels) square += level * level;
  return std::sqrt(square);
}

Figure group_figure(const std::vector<Measured>& group, const study::CaseResults& results) {
  const results::BandLevels& first = group.front().levels;
  double highest = 0;
  for (const Measured& one : group) highest = std::max(highest, std::ranges::max(one.levels.rms));
  const UnitPrefix unit = unit_prefix(highest, results::display_unit(results.display, first.unit));
  PanelRow row;
  for (const Measured& one : group) {
    std::vector<double> heights;
    for (const double rms : one.levels.rms) heights.push_back(rms * unit.factor);
    PanelCurve curve{{one.excitation, fmt::format("{:.4g} {} rms in all bands", overall(heights), unit.unit)},
                     {},
                     {},
                     series_stroke(row.curves.size())};
    set_steps(curve, one.levels.bands, heights, results.display);
    row.curves.push_back(std::move(curve));
  }
  std::ranges::move(limits_of(results, first, unit.factor), std::back_inserter(row.curves));
  double from = row.curves.front().x.front(), to = row.curves.front().x.back();
  for (const PanelCurve& curve : row.curves) from = std::min(from, curve.x.front()), to = std::max(to, curve.x.back());
  row.x = {from, to, true, results::frequency_heading(results.display)};
  row.y =
      logarithmic_axis(row.curves, invisible_level, fmt::format("{} [{} rms]", quantity_name(first.unit), unit.unit));
  const std::string title =
      fmt::format("Measured {} levels of {}", excitation::name(first.width), quantity_name(first.unit));
  return panel_figure(case_title(title, results), "levels-" + file_part(group.front().excitation) + ".svg", {row});
}

}  // namespace

std::vector<Figure> band_level_figures(const project::Case& variant, const study::CaseResults& results) {
  std::vector<Figure> figures;
  for (const std::vector<Measured>& group : groups_of(variant.system.description()))
    figures.push_back(group_figure(group, results));
  return figures;
}

}  // namespace trivet::report
