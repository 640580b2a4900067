// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/report/drawing/amplitude_range.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/curve_panel.h"
#include "trivet/report/drawing/panel_figure.h"
#include "trivet/report/drawing/result_figures.h"
#include "trivet/study/analyses/analysis_results.h"

namespace trivet::report {
namespace {

using foundation::rpm_per_rad_s;
using foundation::two_pi;
constexpr std::size_t most_orders = 5;
constexpr double invisible_order = 1e-4;  // of the largest amplitude

/// The orders with the highest amplitudes relative to the highest of their curve, ascending: the same for all curves,
/// so that a stroke is one order everywhere.
std::vector<std::size_t> tallest_orders(const response::RunUp& run_up) {
  constexpr double negligible = 1e-3;
  std::vector<double> shares(run_up.orders.size(), 0);
  for (std::size_t c = 0; c < run_up.overall.size(); ++c) {
    std::vector<double> heights;
    for (const response::OrderCurves& order : run_up.orders)
      heights.push_back(highest_finite(order.curves[c].value.cwiseAbs()));
    const double highest = *std::ranges::max_element(heights);
    for (std::size_t k = 0; highest > 0 && k < shares.size(); ++k)
      shares[k] = std::max(shares[k], heights[k] / highest);
  }
  std::vector<std::size_t> kept(shares.size());
  std::iota(kept.begin(), kept.end(), std::size_t{0});
  std::ranges::stable_sort(kept, std::greater<>(), [&](std::size_t k) { return shares[k]; });
  if (kept.size() > most_orders) kept.resize(most_orders);
  std::erase_if(kept, [&](std::size_t k) { return shares[k] <= negligible; });
  std::ranges::sort(kept);
  return kept;
}

/// Linear axis from zero, or logarithmic. The sum of all orders decides: no order is above it, and one that is far
/// below it does not matter.
Axis amplitude_axis(const std::vector<PanelCurve>& curves, std::string label) {
  const AmplitudeRange range = amplitude_range({{curves.front().x, curves.front().y}});
  if (range.is_wide()) return logarithmic_axis(curves, invisible_order, std::move(label));
  return airy_axis(0, range.largest, std::move(label));
}

PanelRow amplitude_row(const response::RunUp& run_up, const std::string& name, std::size_t curve,
                       const std::vector<std::size_t>& shown, const project::DisplayUnits& display) {
  const response::Overall& overall = run_up.overall[curve];
  const UnitPrefix unit = unit_prefix(highest_finite(overall.rms), results::display_unit(display, overall.unit));
  // The sum of orders has no other level than rms, so the orders have it too: none can be above the sum.
  const double to_level = project::level_factor(project::Level::rms);
  std::vector<double> rpm;
  for (const double speed : run_up.speed) rpm.push_back(speed * rpm_per_rad_s);
  PanelRow row;
  row.title = name;
  PanelCurve all{{"all orders"}, rpm, {}, "stroke=\"#000000\" stroke-width=\"2.2\" stroke-linejoin=\"round\""};
  for (const double rms : overall.rms) all.y.push_back(rms * unit.factor);
  row.curves.push_back(std::move(all));
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const response::OrderCurves& order = run_up.orders[shown[i]];
    const std::size_t style = i < 4 ? i : 5;  // black is the colour of the sum
    PanelCurve one{{fmt::format("order {:g}", order.order)}, rpm, {}, series_stroke(style)};
    for (const auto& value : order.curves[curve].value) one.y.push_back(std::abs(value) * unit.factor * to_level);
    row.curves.push_back(std::move(one));
    for (const response::CriticalSpeed& critical : run_up.critical)
      if (critical.curve == curve && critical.order == order.order && critical.relative_height >= 0.2)
        row.marks.push_back(
            {critical.speed * rpm_per_rad_s, critical.amplitude * unit.factor * to_level, series_colour(style),
             critical.relative_height == 1 ? fmt::format("{:.0f} rpm", critical.speed * rpm_per_rad_s) : ""});
  }
  row.x = {rpm.front(), rpm.back(), false, "shaft speed [rpm]"};
  row.y = amplitude_axis(row.curves, fmt::format("{} [{} rms]", quantity_name(overall.unit), unit.unit));
  return row;
}

/// The first curve with exactly the same values; a rigid body turns the same at all its points.
std::optional<std::size_t> equal_before(const response::RunUp& run_up, std::size_t curve) {
  for (std::size_t c = 0; c < curve; ++c)
    if (run_up.overall[c].unit == run_up.overall[curve].unit && run_up.overall[c].rms == run_up.overall[curve].rms)
      return c;
  return std::nullopt;
}

/// Panels for the amplitudes of a group, except those below 1e-6 of the largest of the same unit, and those that equal
/// one drawn before, which `as_before` names.
std::vector<PanelRow> amplitude_rows(const response::RunUp& run_up, const std::string& group,
                                     const std::vector<GroupedCurve>& series, const std::vector<std::size_t>& shown,
                                     const project::DisplayUnits& display, std::vector<std::string>& as_before) {
  constexpr double negligible = 1e-6;
  const auto height = [&](const GroupedCurve& s) { return highest_finite(run_up.overall[s.curve].rms); };
  double largest = 0;
  for (const GroupedCurve& s : series) largest = std::max(largest, height(s));
  std::vector<PanelRow> rows;
  for (const GroupedCurve& s : series) {
    if (!(height(s) > negligible * largest)) continue;
    if (const auto before = equal_before(run_up, s.curve))
      as_before.push_back(group + " " + s.label + " = " + run_up.overall[*before].name);
    else rows.push_back(amplitude_row(run_up, group + " " + s.label, s.curve, shown, display));
  }
  return rows;
}

/// A remark in the key: what is not drawn, and why.
PanelCurve remark(std::string words) { return {{std::move(words)}, {}, {}, ""}; }

}  // namespace

std::vector<Figure> run_up_figures(const study::CaseResults& results) {
  std::vector<Figure> figures;
  const auto& orders = results.orders;
  if (!orders || orders->run_up.speed.size() < 2) return figures;
  const response::RunUp& run_up = orders->run_up;
  const std::vector<std::size_t> shown = tallest_orders(run_up);
  std::vector<std::string> as_before;
  std::vector<PanelRow> rows;
  for (const CurveGroup& group : curve_groups(curve_names(run_up.overall)))
    for (const auto* series : {&group.upper, &group.lower})
      for (PanelRow& row : amplitude_rows(run_up, group.name, *series, shown, results.display, as_before))
        rows.push_back(std::move(row));
  if (rows.empty()) return figures;
  std::string remarks = foundation::comma_separated(as_before);
  if (const std::size_t left_out = run_up.orders.size() - shown.size())
    remarks +=
        fmt::format("{}{} weaker order{} not drawn", remarks.empty() ? "" : "; ", left_out, left_out > 1 ? "s" : "");
  if (!remarks.empty()) rows.front().curves.push_back(remark(std::move(remarks)));
  figures.push_back(panel_figure(case_title("Run-up", results), "orders-run-up.svg", rows));
  return figures;
}

}  // namespace trivet::report
