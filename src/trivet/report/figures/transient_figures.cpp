// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/curve_panel.h"
#include "trivet/report/drawing/panel_figure.h"
#include "trivet/report/drawing/result_figures.h"
#include "trivet/study/analyses/analysis_results.h"

namespace trivet::report {
namespace {

/// Unit of the time axis: milliseconds or less if the motion lasts less than a second.
UnitPrefix time_unit(const Eigen::VectorXd& time) { return unit_prefix(time.cwiseAbs().maxCoeff(), "s"); }

std::string extreme_words(const char* which, const response::Extreme& extreme, const UnitPrefix& unit,
                          const UnitPrefix& second) {
  return fmt::format("{} {:.4g} {} at {:.4g} {}", which, extreme.value * unit.factor, unit.unit,
                     extreme.time * second.factor, second.unit);
}

double absolute(const response::TimeCurve& c) {
  return std::max(std::abs(c.largest.value), std::abs(c.smallest.value));
}

PanelRow history_row(const response::TransientResponse& transient, const std::vector<GroupedCurve>& series,
                     const project::DisplayUnits& display) {
  const response::TimeCurve* tallest = &transient.curves[series.front().curve];
  double low = 0, high = 0;
  for (const GroupedCurve& s : series) {
    const response::TimeCurve& c = transient.curves[s.curve];
    if (absolute(c) > absolute(*tallest)) tallest = &c;
    low = std::min(low, c.smallest.value);
    high = std::max(high, c.largest.value);
  }
  const UnitPrefix unit = unit_prefix(absolute(*tallest), results::display_unit(display, tallest->unit)),
                   second = time_unit(transient.time);
  PanelRow row;
  std::vector<double> time;
  for (const double t : transient.time) time.push_back(t * second.factor);
  for (std::size_t i = 0; i < series.size(); ++i) {
    const response::TimeCurve& c = transient.curves[series[i].curve];
    const bool is_zero = is_round_off(transient, c);
    PanelCurve curve{{series[i].label + ", " + extreme_words("max", c.largest, unit, second),
                      extreme_words("min", c.smallest, unit, second)},
                     time,
                     {},
                     series_stroke(i)};
    if (is_zero) curve.key = {series[i].label + ": ≈ 0"};
    for (const double value : c.values) curve.y.push_back(value * unit.factor);
    row.curves.push_back(std::move(curve));
    const bool above = c.largest.value >= -c.smallest.value;
    for (const auto* extreme : {&c.largest, &c.smallest})
      if (!is_zero)
        row.marks.push_back({extreme->time * second.factor, extreme->value * unit.factor, series_colour(i),
                             &c == tallest && above == (extreme == &c.largest)
                                 ? fmt::format("{:.4g} {}", extreme->value * unit.factor, unit.unit)
                                 : ""});
  }
  row.x = {time.front(), time.back(), false, fmt::format("t [{}]", second.unit)};
  row.y =
      airy_axis(low * unit.factor, high * unit.factor, fmt::format("{} [{}]", quantity_name(tallest->unit), unit.unit));
  row.levels = {0};
  return row;
}

}  // namespace

bool is_round_off(const response::TransientResponse& transient, const response::TimeCurve& curve) {
  constexpr double share = 1e-9;
  double largest = 0;
  for (const response::TimeCurve& other : transient.curves)
    if (other.unit == curve.unit) largest = std::max(largest, absolute(other));
  return absolute(curve) <= share * largest;
}

std::vector<Figure> transient_figures(const study::CaseResults& results) {
  std::vector<Figure> figures;
  const auto& found = results.transient;
  if (!found || found->response.time.size() < 2) return figures;
  const response::TransientResponse& transient = found->response;
  for (const CurveGroup& group : curve_groups(curve_names(transient.curves))) {
    std::vector<PanelRow> rows;
    for (const auto* series : {&group.upper, &group.lower})
      if (!series->empty()) rows.push_back(history_row(transient, *series, results.display));
    const std::string title = case_title("Time history: " + group.name, results);
    figures.push_back(panel_figure(title, "transient-" + file_part(group.name) + ".svg", rows));
  }
  return figures;
}

}  // namespace trivet::report
