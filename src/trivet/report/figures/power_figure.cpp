// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/report/drawing/curve_panel.h"
#include "trivet/report/drawing/panel_figure.h"
#include "trivet/report/drawing/result_figures.h"
#include "trivet/response/machinery/power.h"

namespace trivet::report {
namespace {

constexpr double invisible_power = 1e-8;  // of the largest power
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Power in one direction, with gaps where it flows in the other.
PanelCurve one_way(const std::vector<double>& hertz, const Eigen::VectorXd& power, double factor,
                   std::vector<std::string> key, std::string stroke) {
  PanelCurve curve{std::move(key), hertz, {}, std::move(stroke)};
  for (const double p : power) curve.y.push_back(p * factor > 0 ? p * factor : none);
  return curve;
}

/// Is the power into the ground above the round-off of the input power? Rigid ground takes none.
bool flows(const response::PowerFlow& power) {
  constexpr double round_off = 1e-12;
  return power.into_ground.cwiseAbs().maxCoeff() >
      round_off * std::max(power.by_forces.cwiseAbs().maxCoeff(), power.by_ground.cwiseAbs().maxCoeff());
}

std::vector<std::size_t> mounts_with_power(const response::PowerFlow& power) {
  const double largest = power.into_ground.cwiseAbs().maxCoeff();
  std::vector<std::size_t> found;
  for (Eigen::Index m = 0; m < power.into_ground.rows(); ++m)
    if (power.into_ground.row(m).cwiseAbs().maxCoeff() > invisible_power * largest) found.push_back(to_size(m));
  return found;
}

/// Total power: logarithmic, dotted where it comes out of the ground.
PanelRow total_row(const response::PowerFlow& power, const std::vector<double>& hertz, const UnitPrefix& unit) {
  PanelRow row;
  row.curves.push_back(
      one_way(hertz, power.into_ground_in_total, unit.factor, {"all mounts"}, "stroke=\"#000000\" stroke-width=\"2\""));
  PanelCurve back = one_way(hertz, power.into_ground_in_total, -unit.factor, {"all mounts, out of the ground"},
                            "stroke=\"#000000\" stroke-width=\"2\" stroke-dasharray=\"1,4\"");
  if (std::ranges::any_of(back.y, [](double y) { return y > 0; })) row.curves.push_back(std::move(back));
  row.y = logarithmic_axis(row.curves, invisible_power, "mean power [" + unit.unit + "]");
  return row;
}

/// Power of each mount: linear with both signs, because power that enters at one mount may come out at another;
/// logarithmic if none comes out.
PanelRow mount_row(const response::PowerFlow& power, const std::vector<std::size_t>& mounts,
                   const std::vector<double>& hertz, const UnitPrefix& unit) {
  PanelRow row;
  double low = 0, high = 0;
  for (std::size_t i = 0; i < mounts.size(); ++i) {
    const Eigen::VectorXd mine = unit.factor * power.into_ground.row(to_index(mounts[i])).transpose();
    row.curves.push_back({{power.mounts[mounts[i]]}, hertz, {mine.begin(), mine.end()}, series_stroke(i)});
    low = std::min(low, mine.minCoeff());
    high = std::max(high, mine.maxCoeff());
  }
  if (-low > 1e-3 * high) {
    row.y = airy_axis(low, high, "power, + into the ground [" + unit.unit + "]");
    row.levels = {0};
  } else {
    row.y = logarithmic_axis(row.curves, invisible_power, "mean power [" + unit.unit + "]");
  }
  return row;
}

}  // namespace

std::vector<Figure> power_figures(const study::CaseResults& results) {
  const auto& found = results.power;
  if (!found || found->angular_frequency.size() < 3 || found->mounts.empty() || !flows(*found)) return {};
  const response::PowerFlow& power = *found;
  std::vector<double> hertz;
  for (const double omega : power.angular_frequency) hertz.push_back(results::shown_frequency(results.display, omega));
  const UnitPrefix unit = unit_prefix(highest_finite(power.into_ground_in_total.cwiseAbs()), "W");
  const std::vector<std::size_t> mounts = mounts_with_power(power);
  std::vector<PanelRow> rows = {total_row(power, hertz, unit)};
  if (mounts.size() == 1) rows.front().curves.front().key = {"all through " + power.mounts[mounts.front()]};
  else rows.push_back(mount_row(power, mounts, hertz, unit));
  const double lowest = hertz.front() > 0 ? hertz.front() : std::max(hertz[1], 1e-3 * hertz.back());
  for (PanelRow& row : rows) row.x = {lowest, hertz.back(), true, results::frequency_heading(results.display)};
  const std::string title = case_title("Power into the ground", results);
  return {panel_figure(title, "power-ground.svg", rows)};
}

}  // namespace trivet::report
