// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trivet/foundation/constants.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/curve_panel.h"
#include "trivet/report/drawing/result_figures.h"
#include "trivet/study/analyses/analysis_results.h"

namespace trivet::report {
namespace {

using foundation::rpm_per_rad_s;
using foundation::two_pi;
constexpr std::size_t most_orders = 5;
constexpr double spiky = 30, invisible = 1e-4;

/// The orders with the highest amplitudes of a curve, ascending.
std::vector<std::size_t> tallest_orders(const response::RunUp& run_up, std::size_t curve) {
  constexpr double negligible = 1e-3;
  std::vector<std::pair<double, std::size_t>> heights;
  for (std::size_t k = 0; k < run_up.orders.size(); ++k)
    heights.emplace_back(highest_finite(run_up.orders[k].curves[curve].value.cwiseAbs()), k);
  std::sort(heights.rbegin(), heights.rend());
  std::vector<std::size_t> kept;
  for (const auto& [height, k] : heights)
    if (height > negligible * heights.front().first && kept.size() < most_orders) kept.push_back(k);
  std::ranges::sort(kept);
  return kept;
}

double tallest(const std::vector<PanelCurve>& curves) {
  double top = 0;
  for (const PanelCurve& curve : curves)
    top = std::max(top, highest_finite(Eigen::Map<const Eigen::VectorXd>(curve.y.data(), std::ssize(curve.y))));
  return top;
}

/// Linear axis from zero, or logarithmic if a linear one would show only a spike.
Axis amplitude_axis(const std::vector<PanelCurve>& curves, std::string label) {
  std::vector<double> overall;
  for (const double y : curves.front().y)
    if (std::isfinite(y)) overall.push_back(y);
  std::ranges::sort(overall);
  const double top = tallest(curves);
  if (!overall.empty() && top > spiky * overall[overall.size() / 2])
    return logarithmic_axis(curves, invisible, std::move(label));
  return airy_axis(0, top, std::move(label));
}

PanelRow amplitude_row(const response::RunUp& run_up, const std::string& name, std::size_t curve,
                       const project::DisplayUnits& display) {
  const response::Overall& overall = run_up.overall[curve];
  const UnitPrefix unit = unit_prefix(highest_finite(overall.rms), results::display_unit(display, overall.unit));
  const project::Level shown_at = project::shown_level(display, overall.unit);
  const double to_level = project::level_factor(shown_at);
  const std::string level = results::level_words(shown_at);
  std::vector<double> rpm;
  for (const double speed : run_up.speed) rpm.push_back(speed * rpm_per_rad_s);
  PanelRow row;
  PanelCurve all{
      {name + ", all orders, rms"}, rpm, {}, "stroke=\"#000000\" stroke-width=\"2.2\" stroke-linejoin=\"round\""};
  for (const double rms : overall.rms) all.y.push_back(rms * unit.factor);
  row.curves.push_back(std::move(all));
  const std::vector<std::size_t> shown = tallest_orders(run_up, curve);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const response::OrderCurves& order = run_up.orders[shown[i]];
    const std::size_t style = i < 4 ? i : 5;  // black is the colour of the sum
    PanelCurve one{{fmt::format("order {:g}, {}", order.order, level)}, rpm, {}, series_stroke(style)};
    for (const auto& value : order.curves[curve].value) one.y.push_back(std::abs(value) * unit.factor * to_level);
    row.curves.push_back(std::move(one));
    for (const response::CriticalSpeed& critical : run_up.critical)
      if (critical.curve == curve && critical.order == order.order && critical.relative_height >= 0.2)
        row.marks.push_back(
            {critical.speed * rpm_per_rad_s, critical.amplitude * unit.factor * to_level, series_colour(style),
             critical.relative_height == 1 ? fmt::format("{:.0f} rpm", critical.speed * rpm_per_rad_s) : ""});
  }
  const std::size_t left_out = run_up.orders.size() - shown.size();
  if (left_out > 0)
    row.curves.back().key.push_back(fmt::format("({} weaker order{} not drawn)", left_out, left_out > 1 ? "s" : ""));
  row.x = {rpm.front(), rpm.back(), false, "shaft speed [rpm]"};
  row.y = amplitude_axis(row.curves, fmt::format("{} [{}]", quantity_name(overall.unit), unit.unit));
  return row;
}

/// Panels for the amplitudes of a group, except those below 1e-6 of the largest of the same unit.
std::vector<PanelRow> amplitude_rows(const response::RunUp& run_up, const std::vector<GroupedCurve>& series,
                                     const project::DisplayUnits& display) {
  constexpr double negligible = 1e-6;
  const auto height = [&](const GroupedCurve& s) { return highest_finite(run_up.overall[s.curve].rms); };
  double largest = 0;
  for (const GroupedCurve& s : series) largest = std::max(largest, height(s));
  std::vector<PanelRow> rows;
  for (const GroupedCurve& s : series)
    if (height(s) > negligible * largest) rows.push_back(amplitude_row(run_up, s.label, s.curve, display));
  return rows;
}

}  // namespace

std::vector<Figure> run_up_figures(const study::CaseResults& results) {
  std::vector<Figure> figures;
  const auto& orders = results.orders;
  if (!orders || orders->run_up.speed.size() < 2) return figures;
  const response::RunUp& run_up = orders->run_up;
  for (const CurveGroup& group : curve_groups(curve_names(run_up.overall))) {
    std::vector<PanelRow> rows = amplitude_rows(run_up, group.upper, results.display);
    for (PanelRow& row : amplitude_rows(run_up, group.lower, results.display)) rows.push_back(std::move(row));
    if (rows.empty()) continue;
    const std::string title = case_title("Run-up: " + group.name, results);
    figures.push_back(stacked_rows(title, "orders-" + file_part(group.name) + ".svg", rows));
  }
  return figures;
}

}  // namespace trivet::report
