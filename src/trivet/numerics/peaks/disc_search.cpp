// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/peaks/disc_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "trivet/foundation/hertz.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/peaks/axis_panels.h"
#include "trivet/numerics/peaks/response_series.h"
#include "trivet/numerics/sweep/frequency_sweep.h"

namespace trivet::numerics {
namespace {

/// Frequency band [rad/s].
struct Band {
  double from = 0, to = 0;
};

constexpr double round_off = 1e-9;  // relative, of panel ends

/// ω [rad/s] at which the coordinates on a panel are sized: its centre, or the start of the panel at infinity.
double where_sized(const Panel& panel) { return panel.at_infinity ? 1 / panel.radius : panel.centre; }

/// Sizes of the coordinates there if all were as large, in units of `scale`, as the largest.
Eigen::VectorXd sizes_on(const Panel& panel, const SeriesAtInfinity& q, const Eigen::VectorXd& scale) {
  const Eigen::VectorXcd there = panel.at_infinity
      ? Eigen::VectorXcd(std::pow(panel.radius, q.power) * q.coefficients.rowwise().sum())
      : Eigen::VectorXcd(q.coefficients.col(0));
  return there.cwiseAbs().cwiseQuotient(scale).maxCoeff() * scale;
}

/// @return false if the series of the curve is beyond the range of computation
bool search_panel(const ObservedCurve& curve, const Panel& panel, const CoordinateSeries& coordinates,
                  const Eigen::VectorXd& sizes, const Eigen::VectorXd& given, const Band& band, SearchedCurve& result) {
  const CurveSeries series = curve_series(curve, panel, coordinates);
  if (!std::isfinite(size_of(series))) return false;
  if (panel.at_infinity) result.at_end = limit_at_infinity(series, panel);
  else if (const double tau = (band.from - panel.centre) / panel.radius; std::abs(tau) <= 1 + round_off)
    result.at_start = amplitude(series, panel, tau);
  const double size = size_of(series) * (panel.at_infinity ? std::pow(panel.radius, series.power) : 1);
  const double possible =
      possible_amplitudes(curve, sizes, given, Eigen::RowVectorXd::Constant(1, where_sized(panel))).value();
  if (!(size > vanishing_share * possible)) return true;  // only round-off
  result.largest_share = std::max(result.largest_share, size / possible);
  add_extrema(series, panel, band.from, band.to, result.extrema);
  return true;
}

/// Whether the panel is at an undamped pole, within its radius and the accuracy of the pole.
bool stands_on_a_pole(const Panel& panel, const std::vector<double>& poles) {
  constexpr double own_digits = 64 * gap_at_pole;
  return std::ranges::any_of(
      poles, [&](double pole) { return std::abs(where_sized(panel) - pole) <= panel.radius + own_digits * pole; });
}

/// |y|, curves × frequencies, from direct solutions.
Eigen::MatrixXd amplitudes(const DrivenSystem& system, const std::vector<ObservedCurve>& curves,
                           const std::vector<double>& omega) {
  const auto count = to_index(omega.size());
  const Eigen::MatrixXcd q = sweep(system.matrices, system.load, omega).response;
  const Eigen::MatrixXcd given = system.given.at(omega);
  const Eigen::RowVectorXcd at = Eigen::Map<const Eigen::RowVectorXd>(omega.data(), count).cast<Complex>();
  Eigen::MatrixXd result(to_index(curves.size()), count);
  for (std::size_t c = 0; c < curves.size(); ++c)
    result.row(to_index(c)) = curve_values(curves[c], q, given, at).cwiseAbs();
  return result;
}

/// @param beside_free_motion  the search begins near a rigid-body mode: Z may count as singular there, although a curve
/// without that mode is finite, as its series shows
void note_ends_and_poles(const DrivenSystem& system, const std::vector<ObservedCurve>& curves,
                         const std::vector<double>& poles, bool beside_free_motion, AxisSearch& search) {
  std::vector<double> omega = {search.from};
  if (std::isfinite(search.to)) omega.push_back(search.to);
  const auto ends = to_index(omega.size());
  for (const double pole : poles)
    for (const double beside : around_pole(pole)) omega.push_back(beside);
  const Eigen::MatrixXd y = amplitudes(system, curves, omega);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const auto row = to_index(c);
    SearchedCurve& curve = search.curves[c];
    if (!beside_free_motion || !std::isnan(y(row, 0)))
      curve.at_start = y(row, 0);  // else the value from a panel, if any
    if (ends > 1) curve.at_end = y(row, 1);
    Eigen::Index at = ends;
    for (const double pole : poles) {
      const std::array<double, 4> beside = {y(row, at), y(row, at + 1), y(row, at + 2), y(row, at + 3)};
      if (is_unbounded(beside)) curve.extrema.push_back(unbounded_at(pole));
      else if (const auto maximum = bounded_at(pole, beside)) curve.extrema.push_back(*maximum);
      at += 4;
    }
    curve.extrema = alternating(std::move(curve.extrema));
  }
}

}  // namespace

AxisSearch search_by_discs(const DrivenSystem& system, const std::vector<ObservedCurve>& curves,
                           const Eigen::VectorXcd& poles, const DiscSearchOptions& options) {
  const double delay = std::max(system.load.longest_delay(), system.given.longest_delay());
  const bool unbounded_at_rest = std::min(system.load.lowest_power(), system.given.lowest_power()) < 0;
  const PanelCover cover =
      cover_axis(poles, {.unbounded_at_rest = unbounded_at_rest, .longest_delay = delay, .highest = options.to});
  AxisSearch result{std::vector<SearchedCurve>(curves.size()), std::max(options.from, cover.lowest), options.to,
                    static_cast<int>(cover.panels.size())};
  if (system.load.vanishes() && system.given.vanishes()) return result;
  const Eigen::VectorXd scale = unit_scale(system.matrices);
  // Panels of a delayed load end beyond the band: the curve there determines the prominence of the last peaks.
  const Band band{result.from, delay > 0 ? std::numeric_limits<double>::infinity() : options.to};
  for (SearchedCurve& curve : result.curves) {
    curve.at_start = std::numeric_limits<double>::quiet_NaN();
    curve.complete = result.from < result.to;  // else the whole band is below the start of the cover
  }
  const ResponseSeries response(system.matrices, system.load);
  double done = 0;
  const double all =
      static_cast<double>(cover.panels.size()) * static_cast<double>(std::max<std::size_t>(curves.size(), 1));
  for (const Panel& panel : cover.panels) {
    foundation::report_progress(options.progress, "peaks", done / all);
    done += static_cast<double>(curves.size());
    if (panel.at_infinity ? band.to < 1 / panel.radius
                          : panel.centre + panel.radius < band.from || panel.centre - panel.radius > band.to)
      continue;
    const CoordinateSeries q = coordinate_series(response, system.given, panel);
    const auto note_gap = [&](SearchedCurve& curve) {
      curve.complete = false;
      if (!stands_on_a_pole(panel, cover.poles_on_axis))
        throw foundation::NotComputable(fmt::format(
            "peaks: near {} the response is beyond the range of computation, as near a rigid-body mode "
            "with a stiffness of round-off only: support that direction, or check the magnitudes of masses, "
            "stiffnesses and dampings",
            foundation::hertz_words(where_sized(panel))));
    };
    if (!q.response.coefficients.allFinite()) {  // exactly at an undamped pole, or no solver is accurate here
      for (SearchedCurve& curve : result.curves) note_gap(curve);
      continue;
    }
    const Eigen::VectorXd sizes = sizes_on(panel, q.response, scale);
    const Eigen::VectorXd given =
        system.given.vanishes() ? Eigen::VectorXd() : system.given.possible(where_sized(panel));
    for (std::size_t c = 0; c < curves.size(); ++c) {
      foundation::report_progress(options.progress, "peaks", (done - static_cast<double>(curves.size() - c)) / all);
      if (!search_panel(curves[c], panel, q, sizes, given, band, result.curves[c])) note_gap(result.curves[c]);
    }
  }
  std::vector<double> inside;
  for (const double pole : cover.poles_on_axis)
    if (pole >= band.from && pole <= band.to) inside.push_back(pole);
  note_ends_and_poles(system, curves, inside, cover.lowest > 0, result);
  return result;
}

}  // namespace trivet::numerics
