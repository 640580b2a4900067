// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "trivet/report/answer_figures.h"
#include "trivet/report/curve_panel.h"

namespace trivet::report {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double invisible = 1e-8;  // of the largest power
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Power one way, gaps where it flows the other way.
PanelCurve one_way(const std::vector<double>& hertz, const Eigen::VectorXd& power, double factor, std::vector<std::string> key,
                   std::string stroke) {
  PanelCurve curve{std::move(key), hertz, {}, std::move(stroke)};
  for (const double p : power) curve.y.push_back(p * factor > 0 ? p * factor : none);
  return curve;
}

/// Does anything enter the ground beyond round-off of what the excitations feed in? A rigid ground takes nothing.
bool flows(const response::PowerFlow& power) {
  constexpr double round_off = 1e-12;
  return power.into_ground.cwiseAbs().maxCoeff() >
         round_off * std::max(power.by_forces.cwiseAbs().maxCoeff(), power.by_ground.cwiseAbs().maxCoeff());
}

std::vector<std::size_t> mounts_with_power(const response::PowerFlow& power) {
  const double largest = power.into_ground.cwiseAbs().maxCoeff();
  std::vector<std::size_t> found;
  for (Eigen::Index m = 0; m < power.into_ground.rows(); ++m)
    if (power.into_ground.row(m).cwiseAbs().maxCoeff() > invisible * largest) found.push_back(static_cast<std::size_t>(m));
  return found;
}

bool any_positive(const PanelCurve& curve) {
  return std::any_of(curve.y.begin(), curve.y.end(), [](double y) { return y > 0; });
}

}  // namespace

std::vector<Figure> power_figures(const study::Answers& answers) {
  if (!answers.power || answers.power->angular_frequency.size() < 3 || answers.power->mounts.empty()) return {};
  const response::PowerFlow& power = *answers.power;
  std::vector<double> hertz;
  for (const double omega : power.angular_frequency) hertz.push_back(omega / turn);
  double largest = 0;
  for (const double p : power.into_ground_in_total)
    if (std::isfinite(p)) largest = std::max(largest, std::abs(p));
  if (!flows(power)) return {};
  const UnitPrefix unit = unit_prefix(largest, "W");
  PanelRow row;
  row.curves.push_back(one_way(hertz, power.into_ground_in_total, unit.factor, {"total"},
                               "stroke=\"#000000\" stroke-width=\"2.4\" stroke-linejoin=\"round\""));
  std::vector<PanelCurve> back;
  back.push_back(one_way(hertz, power.into_ground_in_total, -unit.factor, {"total, out of the ground"},
                         "stroke=\"#000000\" stroke-width=\"1.2\" stroke-dasharray=\"1,4\""));
  const std::vector<std::size_t> mounts = mounts_with_power(power);
  if (mounts.size() == 1) row.curves.front().key.push_back("all of it by " + power.mounts[mounts.front()]);
  for (std::size_t i = 0; i < mounts.size() && mounts.size() > 1; ++i) {
    const std::size_t m = mounts[i], style = i % 5 < 4 ? i % 5 : 5;  // black is the total's
    const Eigen::VectorXd mine = power.into_ground.row(static_cast<Eigen::Index>(m)).transpose();
    row.curves.push_back(one_way(hertz, mine, unit.factor, {power.mounts[m]}, series_stroke(style)));
    back.push_back(one_way(hertz, mine, -unit.factor, {power.mounts[m] + ", out of the ground"},
                           std::string("stroke=\"") + series_colour(style) + "\" stroke-width=\"1.2\" stroke-dasharray=\"1,4\""));
  }
  for (PanelCurve& curve : back)
    if (any_positive(curve)) row.curves.push_back(std::move(curve));
  row.x = {hertz.front() > 0 ? hertz.front() : std::max(hertz[1], 1e-3 * hertz.back()), hertz.back(), true, "f [Hz]"};
  row.y = logarithmic_axis(row.curves, invisible, "mean power into the ground [" + unit.unit + "]");
  const std::string title = case_title("Power into the ground", answers);
  return {{title, "power-ground.svg", stacked_rows(title, {row})}};
}

}  // namespace trivet::report
