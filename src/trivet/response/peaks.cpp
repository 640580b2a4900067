// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/peaks.h"

#include <algorithm>
#include <cmath>

#include "trivet/numerics/response_series.h"
#include "trivet/numerics/sign_changes.h"
#include "trivet/response/curve_series.h"
#include "trivet/response/frequency_response.h"
#include "trivet/response/peak_refinement.h"

namespace trivet::response {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// A curve below this share of what its coordinates could make of it is zero but for round-off.
constexpr double vanishing = 1e-12;
/// Panels are searched a little beyond their ends, so that an extremum on a seam is not lost; repeats merge afterwards.
constexpr double overlap = 1e-6;
/// Below this share of the first panel's radius an extremum stands at ω = 0.
constexpr double at_rest = 1e-7;

/// What one walk along the axis collects for one curve.
struct Walk {
  std::vector<Turning> turnings;
  double largest_share = 0;   ///< of |y| in what the coordinates could make of it
  double start = 0, end = 0;  ///< |y| at the lowest frequency and at infinity
};

/// |y| if all coordinates (in units of √mass) worked together.
double possible_amplitude(const assembly::Channel& channel, const Eigen::VectorXd& scale, const Eigen::VectorXcd& q, double omega) {
  const double level = q.cwiseAbs().cwiseQuotient(scale).maxCoeff();
  const double reach = (channel.on_displacement.cwiseAbs() + omega * channel.on_velocity.cwiseAbs()).dot(scale);
  return std::pow(omega, channel.derivative) * reach * level;
}

void walk_panel(const assembly::Channel& channel, const Panel& panel, const Eigen::MatrixXcd& q, const Eigen::VectorXd& scale, Walk& walk) {
  const CurveSeries series = curve_series(channel, panel, q);
  if (panel.at_infinity) {
    walk.end = series.power > 0 ? 0 : amplitude(series, panel, 0);
  } else {
    const double possible = possible_amplitude(channel, scale, q.col(0), panel.centre);
    const double size = std::sqrt(std::abs(*std::max_element(series.square.begin(), series.square.end(), [](double a, double b) { return std::abs(a) < std::abs(b); })));
    if (!(size > vanishing * possible)) return;  // its ups and downs are round-off
    walk.largest_share = std::max(walk.largest_share, size / possible);
  }
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

/// Ascending, and of neighbours of one kind (an extremum seen from two panels) only the more extreme.
std::vector<Turning> alternating(std::vector<Turning> all) {
  std::stable_sort(all.begin(), all.end(), [](const Turning& a, const Turning& b) { return a.angular_frequency < b.angular_frequency; });
  std::vector<Turning> result;
  for (const Turning& t : all) {
    if (!result.empty() && result.back().maximum == t.maximum) {
      if ((t.amplitude > result.back().amplitude) == t.maximum) result.back() = t;
    } else {
      result.push_back(t);
    }
  }
  return result;
}

/// Height above the higher of the lowest points on either side before higher ground (or the end of the axis).
double prominence(const std::vector<Turning>& turnings, std::size_t peak, double start, double end) {
  const double height = turnings[peak].amplitude;
  double left = height, right = height;
  std::size_t i = peak;
  while (i > 0 && !(turnings[i - 1].amplitude > height)) left = std::min(left, turnings[--i].amplitude);
  if (i == 0) left = std::min(left, start);
  std::size_t j = peak;
  while (j + 1 < turnings.size() && !(turnings[j + 1].amplitude > height)) right = std::min(right, turnings[++j].amplitude);
  if (j + 1 == turnings.size()) right = std::min(right, end);
  return std::isinf(height) ? infinity : height - std::max(left, right);
}

/// Does |y| grow like 1/distance on both sides of an undamped pole?
bool is_unbounded(const assembly::Assembled& assembled, const assembly::Channel& channel, const Eigen::VectorXcd& load, double pole) {
  const double near = 16 * gap_at_pole, far = 160 * gap_at_pole;
  const FrequencyResponse around =
      frequency_response(assembled, {channel}, load, {pole * (1 - far), pole * (1 - near), pole * (1 + near), pole * (1 + far)});
  const Eigen::VectorXd y = around.curves[0].value.cwiseAbs();
  return y(1) > 9 * y(0) && y(2) > 9 * y(3);  // a pole in reach gives 10
}

}  // namespace

Peaks peaks(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels, const Eigen::VectorXcd& load,
            const modal::Modes& modes, const modal::Roots& roots, const PeakOptions& options, const foundation::Progress& progress) {
  const numerics::DynamicMatrices& m = assembled.matrices;
  const Eigen::VectorXd scale = numerics::unit_scale(m.A);
  const PanelCover cover = cover_axis(roots.poles);
  Peaks result;
  result.searched_from = cover.lowest;
  result.panels = static_cast<int>(cover.panels.size());
  result.turnings.resize(channels.size());
  const bool loaded = load.cwiseAbs().maxCoeff() > 0;

  std::vector<Walk> walks(channels.size());
  if (loaded)
    for (std::size_t p = 0; p < cover.panels.size(); ++p) {
      const Panel& panel = cover.panels[p];
      const Eigen::MatrixXcd q = panel.at_infinity ? numerics::response_series_at_infinity(m, load, panel.radius, series_order)
                                                   : numerics::response_series(m, load, panel.centre, panel.radius, series_order);
      if (!q.allFinite()) continue;  // stands on an undamped pole to the last digit: the gap around it is treated below
      for (std::size_t c = 0; c < channels.size(); ++c) walk_panel(channels[c], panel, q, scale, walks[c]);
      foundation::report_progress(progress, "peaks", 0.5 * static_cast<double>(p) / static_cast<double>(cover.panels.size()));
    }

  const bool rigid = cover.lowest > 0 || modal::has_rigid_motion(modes);
  const FrequencyResponse first = frequency_response(assembled, channels, load, {cover.lowest});
  for (std::size_t c = 0; c < channels.size(); ++c) {
    CurveSummary& summary = result.curves.emplace_back(CurveSummary{channels[c].name, channels[c].unit, {}, 0, 0, false, 0});
    Walk& walk = walks[c];
    walk.start = std::abs(first.curves[c].value(0));
    if (!rigid && std::isfinite(walk.start)) summary.static_amplitude = walk.start;
    summary.vanishes = !loaded || walk.largest_share <= vanishing;
    if (summary.vanishes) continue;
    for (const double pole : cover.poles_on_axis)
      if (is_unbounded(assembled, channels[c], load, pole)) walk.turnings.push_back({pole, infinity, true, gap_at_pole * pole, 0});
    result.turnings[c] = alternating(std::move(walk.turnings));

    double finite_top = std::max(std::isfinite(walk.start) ? walk.start : 0, walk.end);
    summary.highest = finite_top;
    summary.highest_at = walk.end > walk.start ? infinity : cover.lowest;
    for (const Turning& t : result.turnings[c]) {
      if (std::isfinite(t.amplitude)) finite_top = std::max(finite_top, t.amplitude);
      if (t.amplitude > summary.highest) {
        summary.highest = t.amplitude;
        summary.highest_at = t.angular_frequency;
      }
    }
    for (std::size_t i = 0; i < result.turnings[c].size(); ++i) {
      const Turning& t = result.turnings[c][i];
      if (!t.maximum) continue;
      foundation::report_progress(progress, "peaks", 0.5 + 0.5 * static_cast<double>(c) / static_cast<double>(channels.size()));
      Peak peak{c, t.angular_frequency, t.amplitude, prominence(result.turnings[c], i, walk.start, walk.end), {}, {}, t.uncertainty, 0, false};
      if (!(peak.prominence > options.min_prominence * finite_top)) continue;
      if (std::isfinite(t.amplitude)) {
        const RefinedPeak refined = refine_peak(assembled, channels[c], load, t.angular_frequency, t.reach);
        if (refined.converged) {
          peak.prominence += refined.amplitude - peak.amplitude;
          peak.angular_frequency = refined.angular_frequency;
          peak.amplitude = refined.amplitude;
          peak.frequency_uncertainty = refined.frequency_uncertainty;
          peak.amplitude_uncertainty = refined.amplitude_uncertainty;
          peak.refined = true;
          summary.highest = std::max(summary.highest, peak.amplitude);
        }
      } else {
        peak.refined = true;
      }
      if (summary.static_amplitude && *summary.static_amplitude > 0) peak.ratio_to_static = peak.amplitude / *summary.static_amplitude;
      peak.nearest_mode = modal::nearest_mode(modes, peak.angular_frequency, m.size());
      ++summary.peaks;
      result.list.push_back(peak);
    }
  }
  return result;
}

}  // namespace trivet::response
