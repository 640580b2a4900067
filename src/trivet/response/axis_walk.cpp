// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/axis_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/response_series.h"
#include "trivet/numerics/sign_changes.h"
#include "trivet/response/curve_series.h"
#include "trivet/response/exact_response.h"
#include "trivet/response/frequency_response.h"

namespace trivet::response {
namespace {

using Complex = std::complex<double>;

/// Panels are searched a little beyond their ends, so that an extremum on a seam is not lost; repeats merge afterwards.
constexpr double overlap = 1e-6;
/// Below this share of the first panel's radius an extremum stands at ω = 0.
constexpr double at_rest = 1e-7;

/// |y| if all coordinates (in units of √mass) and all motions of the ground worked together.
double possible_amplitude(const assembly::Channel& channel, const Eigen::VectorXd& scale, const Eigen::VectorXcd& q, const Eigen::VectorXd& ground,
                          double omega) {
  const double level = q.cwiseAbs().cwiseQuotient(scale).maxCoeff();
  double reach = level * (channel.on_displacement.cwiseAbs() + omega * channel.on_velocity.cwiseAbs() +
                          omega * omega * channel.on_acceleration.cwiseAbs()).dot(scale);
  if (!channel.ground.empty() && ground.size() > 0)
    reach += (channel.ground.on_displacement.cwiseAbs() + omega * channel.ground.on_velocity.cwiseAbs() +
              omega * omega * channel.ground.on_acceleration.cwiseAbs()).dot(ground);
  return std::pow(omega, channel.derivative) * reach;
}

void note_turnings(const CurveSeries& series, const numerics::Panel& panel, Walk& walk) {
  const double lower = panel.at_infinity ? 0 : -1 - overlap;
  std::vector<numerics::SignChange> changes = numerics::sign_changes(slope(series), lower, 1 + overlap);
  if (panel.at_infinity) std::reverse(changes.begin(), changes.end());
  for (const numerics::SignChange& change : changes) {
    if (panel.at_infinity && !(change.at > 0)) continue;
    const double omega = angular_frequency(panel, change.at);
    // |y|² is even about ω = 0 without damping: the extremum at rest is no peak, and round-off may put it beside 0.
    if (!panel.at_infinity && !(omega > at_rest * panel.radius)) continue;
    // A maximum stays one whichever way the axis runs.
    const double step = panel.at_infinity ? omega : panel.radius;
    walk.turnings.push_back({omega, amplitude(series, panel, change.at), change.falling, step, step * change.uncertainty});
  }
}

double size_of(const CurveSeries& series) {
  double largest = 0;
  for (const double s : series.square) largest = std::max(largest, std::abs(s));
  return std::sqrt(largest);
}

void walk_panel(const assembly::Channel& channel, const numerics::Panel& panel, const CoordinateSeries& q, const Eigen::VectorXd& scale,
                const Eigen::VectorXd& ground, Walk& walk) {
  const CurveSeries series = curve_series(channel, panel, q);
  if (panel.at_infinity) {
    const bool grows = series.power < 0 && size_of(series) > 0;
    walk.end = grows ? std::numeric_limits<double>::infinity() : series.power > 0 ? 0 : amplitude(series, panel, 0);
  } else {
    const double possible = possible_amplitude(channel, scale, q.free.coefficients.col(0), ground, panel.centre);
    if (!(size_of(series) > vanishing_share * possible)) return;  // its ups and downs are round-off
    walk.largest_share = std::max(walk.largest_share, size_of(series) / possible);
  }
  note_turnings(series, panel, walk);
}

/// Samples on a circle of radius `spread` panel radii, and how small what betrays a pole must be.
constexpr int samples = 64;
constexpr double spread = 1.25;
constexpr int betraying = 8;
constexpr double pole_free = 1e-11;
/// Round-off of a curve, as a share of what its terms could make of it: a few units times the condition of Z, and never so much that a
/// pole could hide in it.
double round_off(double condition) {
  constexpr double count = 16, most = 1e-6;
  return std::min(count * std::numeric_limits<double>::epsilon() * condition, most);
}
/// So many gaps without a panel between them are no undamped poles: the laws cannot be continued here.
constexpr int most_gaps_in_a_row = 200;

/// Taylor coefficients of every curve (rows) in τ, ω = centre + radius τ; empty if a pole is too near.
Eigen::MatrixXcd contour_series(const ExactResponse& exact, const numerics::Panel& panel, Eigen::VectorXd& level, Eigen::VectorXd& possible) {
  std::vector<Eigen::VectorXcd> values;
  possible.resize(0);
  double condition = 0;
  for (int k = 0; k < samples; ++k) {
    const ExactSample sample = exact.at(panel.centre + spread * panel.radius * std::polar(1.0, 2 * std::numbers::pi * k / samples), panel.centre);
    if (!sample.values.allFinite()) return {};
    values.push_back(sample.values);
    condition = std::max(condition, sample.condition);
    possible = k == 0 ? sample.possible : Eigen::VectorXd(possible.cwiseMax(sample.possible));
  }
  const Eigen::Index curves = values[0].size();
  Eigen::MatrixXcd series = Eigen::MatrixXcd::Zero(curves, samples);
  level.setZero(curves);
  for (int j = 0; j < samples; ++j)
    for (int k = 0; k < samples; ++k) series.col(j) += values[static_cast<std::size_t>(k)] * std::polar(1.0 / samples, -2 * std::numbers::pi * ((j * k) % samples) / samples);
  for (const auto& v : values) level = level.cwiseMax(v.cwiseAbs());
  // Coefficients of the last powers are those of the first negative ones: the principal part of a pole inside.
  for (Eigen::Index c = 0; c < curves; ++c)
    if (series.row(c).tail(betraying).cwiseAbs().maxCoeff() > std::max(pole_free * level(c), round_off(condition) * possible(c))) return {};
  double power = 1;
  for (int j = 0; j < samples; ++j, power /= spread) series.col(j) *= power;
  return series.leftCols(samples - betraying);
}

CurveSeries squared(const Eigen::RowVectorXcd& y) {
  CurveSeries result;
  result.square.assign(static_cast<std::size_t>(y.size()), 0.0);
  for (Eigen::Index k = 0; k < y.size(); ++k)
    for (Eigen::Index j = 0; j <= k; ++j) result.square[static_cast<std::size_t>(k)] += (std::conj(y(j)) * y(k - j)).real();
  return result;
}

void note_ends(const FrequencyResponse& at_the_end, AxisWalk& walk) {
  for (std::size_t c = 0; c < walk.curves.size(); ++c) walk.curves[c].end = std::abs(at_the_end.curves[c].value(0));
}

/// d|y|²/dτ at an end of a panel.
double slope_at(const CurveSeries& series, double tau) {
  double sum = 0, power = 1;
  for (std::size_t k = 1; k < series.square.size(); ++k, power *= tau) sum += static_cast<double>(k) * series.square[k] * power;
  return sum;
}

/// Where one piece of a table ends and the next begins a curve may have a corner, and an extremum there that no derivative shows.
void note_corner(double before, double after, const CurveSeries& series, const numerics::Panel& panel, Walk& walk) {
  constexpr double significant = 1e-9;
  const double square = std::max(numerics::polynomial_value(series.square, -1), 0.0);
  if (!(before * after < 0) || !(std::min(std::abs(before), std::abs(after)) > significant * square / panel.radius)) return;
  walk.turnings.push_back({panel.centre - panel.radius, std::sqrt(square), before > 0, panel.radius, 0});
}

double first_guess(const Eigen::VectorXcd& poles, double from) {
  const double distance = (poles.array() - Complex(0, from)).abs().minCoeff();
  return std::max(numerics::panel_ratio * distance, 1e-6 * from);
}

}  // namespace

AxisWalk walk_by_poles(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels, const assembly::Loading& loading,
                       const Eigen::VectorXcd& poles, double highest, const foundation::Progress& progress) {
  const numerics::DynamicMatrices& m = assembled.matrices;
  const Eigen::VectorXd scale = numerics::unit_scale(m);
  const bool delayed = loading.longest_delay() > 0;
  Eigen::VectorXcd all_poles = poles;
  if (loading.lowest_power() < 0) {  // what is given by its acceleration grows without end at ω = 0
    all_poles.conservativeResize(poles.size() + 1);
    all_poles(poles.size()) = 0;
  }
  numerics::PanelCover cover = numerics::cover_axis(all_poles, {loading.longest_delay(), highest});
  AxisWalk result{std::vector<Walk>(channels.size()), std::move(cover.poles_on_axis), cover.lowest,
                  delayed ? highest : std::numeric_limits<double>::infinity(), static_cast<int>(cover.panels.size())};
  const numerics::Load h = assembly::right_side(assembled, loading);
  if (loading.vanishes()) return result;
  for (std::size_t p = 0; p < cover.panels.size(); ++p) {
    const numerics::Panel& panel = cover.panels[p];
    const CoordinateSeries q = coordinate_series(m, h, loading.motion, panel);
    if (!q.free.coefficients.allFinite()) continue;  // stands on an undamped pole to the last digit: the gap around it is treated as such
    const Eigen::VectorXd ground = panel.at_infinity || loading.motion.vanishes() ? Eigen::VectorXd() : loading.motion.possible(panel.centre);
    for (std::size_t c = 0; c < channels.size(); ++c) walk_panel(channels[c], panel, q, scale, ground, result.curves[c]);
    foundation::report_progress(progress, "peaks", 0.5 * static_cast<double>(p) / static_cast<double>(cover.panels.size()));
  }
  if (delayed) note_ends(frequency_response(assembled, channels, loading, {highest}), result);
  return result;
}

AxisWalk walk_by_contours(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels, const assembly::Loading& loading,
                          const Eigen::VectorXcd& near_poles, double highest, const foundation::Progress& progress) {
  constexpr double start_share = 1e-3, growth = 1.6, at_the_end = 1e-9, on_a_seam = 1e-10;  // the latter smaller, so that a seam is always ahead
  AxisWalk result{std::vector<Walk>(channels.size()), {}, 0, highest, 0};
  double smallest = highest;
  for (Eigen::Index k = 0; k < near_poles.size(); ++k)
    if (std::abs(near_poles(k)) > 0 && near_poles(k).imag() != 0) smallest = std::min(smallest, std::abs(near_poles(k)));
  for (const assembly::ElementMap& map : assembled.elements) result.lowest = std::max(result.lowest, map.defined_from);
  if (result.lowest == 0) result.lowest = start_share * smallest;
  if (loading.vanishes() || !(highest > result.lowest)) return result;
  const ExactResponse exact(assembled, channels, loading);
  std::vector<double> seams = {highest};
  for (const assembly::ElementMap& map : assembled.elements) seams.insert(seams.end(), map.knots.begin(), map.knots.end());
  std::sort(seams.begin(), seams.end());
  int gaps = 0;
  std::vector<double> rise(channels.size(), 0);  // d|y|²/dω at the end of the panel before
  double from = result.lowest, radius = first_guess(near_poles, from);
  while (from < highest * (1 - at_the_end)) {
    foundation::report_progress(progress, "peaks", 0.5 * from / highest);
    // The whole circle must lie where the laws are defined: Re ω > 0.
    const double seam = *std::upper_bound(seams.begin(), seams.end(), from * (1 + on_a_seam));
    radius = std::min({radius, 0.5 * (std::min(seam, highest) - from), from / (spread - 1) * 0.9});
    const numerics::Panel panel{from + radius, radius, false};
    Eigen::VectorXd level, possible;
    const Eigen::MatrixXcd series = contour_series(exact, panel, level, possible);
    if (series.size() == 0) {
      radius *= 0.5;
      if (radius > numerics::gap_at_pole * from) continue;
      std::fill(rise.begin(), rise.end(), 0);
      if (++gaps > most_gaps_in_a_row) throw foundation::NotComputable(fmt::format("peaks: the laws of the elements give no smooth curve at {:.6g} rad/s", from));
      result.poles_on_axis.push_back(from * (1 + numerics::gap_at_pole));
      from *= 1 + 4 * numerics::gap_at_pole;
      radius = 4 * numerics::gap_at_pole * from;
      continue;
    }
    ++result.panels;
    gaps = 0;
    for (std::size_t c = 0; c < channels.size(); ++c) {
      const auto row = static_cast<Eigen::Index>(c);
      if (!(level(row) > vanishing_share * possible(row))) continue;  // its ups and downs are round-off
      result.curves[c].largest_share = std::max(result.curves[c].largest_share, level(row) / possible(row));
      const CurveSeries square = squared(series.row(row));
      note_corner(rise[c], slope_at(square, -1) / panel.radius, square, panel, result.curves[c]);
      rise[c] = slope_at(square, 1) / panel.radius;
      note_turnings(square, panel, result.curves[c]);
    }
    from += 2 * radius;
    radius *= growth;
  }
  const ExactSample last = exact.at(highest);
  for (std::size_t c = 0; c < channels.size(); ++c) result.curves[c].end = std::abs(last.values(static_cast<Eigen::Index>(c)));
  return result;
}

}  // namespace trivet::response
