// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/peaks.h"

#include <algorithm>
#include <cmath>

#include "trivet/numerics/axis_panels.h"
#include "trivet/response/axis_walk.h"
#include "trivet/response/carried_motion.h"
#include "trivet/response/frequency_response.h"
#include "trivet/response/peak_refinement.h"

namespace trivet::response {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

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
bool is_unbounded(const assembly::Assembled& assembled, const assembly::Channel& channel, const assembly::Loading& loading, double pole) {
  const double near = 16 * numerics::gap_at_pole, far = 160 * numerics::gap_at_pole;
  const FrequencyResponse around =
      frequency_response(assembled, {channel}, loading, {pole * (1 - far), pole * (1 - near), pole * (1 + near), pole * (1 + far)});
  const Eigen::VectorXd y = around.curves[0].value.cwiseAbs();
  return y(1) > 9 * y(0) && y(2) > 9 * y(3);  // a pole in reach gives 10
}

bool defined_at_rest(const assembly::Assembled& assembled) {
  return std::all_of(assembled.elements.begin(), assembled.elements.end(), [](const assembly::ElementMap& map) { return map.defined_from == 0; });
}

/// Frequency-dependent elements have no last pole: the search ends where the caller says, or well above the natural frequencies, and
/// nowhere beyond a table.
double search_end(const assembly::Assembled& assembled, const modal::Modes& modes, const modal::Roots& roots, const PeakOptions& options) {
  constexpr double well_above = 2;
  double highest = 0;
  for (const modal::Mode& mode : modes.list) highest = std::max(highest, mode.angular_frequency.value_or(0));
  for (const modal::Root& root : roots.list) highest = std::max(highest, root.exact ? root.damped_angular_frequency.value_or(0) : 0);
  double end = std::max(options.search_to, well_above * highest);
  for (const assembly::ElementMap& map : assembled.elements) end = std::min(end, map.defined_to);
  return end;
}

}  // namespace

double relative_prominence(const Peak& peak) {
  const double minimum = peak.amplitude - peak.prominence;
  return std::isinf(peak.amplitude) || !(minimum > 0) ? infinity : peak.prominence / minimum;
}

Peaks peaks(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels, const assembly::Loading& loading,
            const modal::Modes& modes, const modal::Roots& roots, const PeakOptions& options, const foundation::Progress& progress) {
  if (const auto beyond = beyond_carried(assembled, channels, loading)) return peaks(beyond->assembled, beyond->channels, loading, modes, roots, options, progress);
  const numerics::DynamicMatrices& m = assembled.matrices;
  const bool loaded = !loading.vanishes();
  const bool exact = assembled.frequency_dependent();
  AxisWalk walk_along = exact ? walk_by_contours(assembled, channels, loading, roots.poles, search_end(assembled, modes, roots, options), progress)
                              : walk_by_poles(assembled, channels, loading, roots.poles, search_end(assembled, modes, roots, options), progress);
  std::vector<Walk>& walks = walk_along.curves;
  Peaks result;
  result.searched_from = walk_along.lowest;
  result.searched_to = walk_along.highest;
  result.panels = walk_along.panels;
  result.from_circles = exact;
  result.turnings.resize(channels.size());

  const bool rigid = modal::has_rigid_motion(modes) || loading.lowest_power() < 0 || (!exact && walk_along.lowest > 0);
  const FrequencyResponse first = frequency_response(assembled, channels, loading, {rigid || !defined_at_rest(assembled) ? walk_along.lowest : 0.0});
  for (std::size_t c = 0; c < channels.size(); ++c) {
    CurveSummary& summary = result.curves.emplace_back(CurveSummary{channels[c].name, channels[c].unit, {}, 0, 0, false, 0});
    Walk& walk = walks[c];
    walk.start = std::abs(first.curves[c].value(0));
    if (!rigid && defined_at_rest(assembled) && std::isfinite(walk.start)) summary.static_amplitude = walk.start;
    summary.vanishes = !loaded || walk.largest_share <= vanishing_share;
    if (summary.vanishes) continue;
    for (const double pole : walk_along.poles_on_axis)
      if (is_unbounded(assembled, channels[c], loading, pole)) walk.turnings.push_back({pole, infinity, true, numerics::gap_at_pole * pole, 0});
    result.turnings[c] = alternating(std::move(walk.turnings));

    // Towards a free motion or an unbounded motion of the ground a curve may rise without end: that is no scale for its peaks.
    double finite_top = 0;
    for (const double end : {rigid ? 0 : walk.start, walk.end})
      if (std::isfinite(end)) finite_top = std::max(finite_top, end);
    summary.highest = std::max(std::isnan(walk.start) ? 0 : walk.start, walk.end);
    summary.highest_at = walk.end > walk.start ? walk_along.highest : walk_along.lowest;
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
        const RefinedPeak refined = exact            ? RefinedPeak{t.angular_frequency, t.amplitude, t.uncertainty, contour_accuracy * t.amplitude, true}
                                    : options.refine ? refine_peak(assembled, channels[c], loading, t.angular_frequency, t.reach)
                                                     : RefinedPeak{};
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
      if (summary.static_amplitude && *summary.static_amplitude > vanishing_share * peak.amplitude) peak.ratio_to_static = peak.amplitude / *summary.static_amplitude;
      peak.nearest_mode = modal::nearest_mode(modes, peak.angular_frequency, static_cast<Eigen::Index>(numerics::massive_rows(m.A).size()));
      ++summary.peaks;
      result.list.push_back(peak);
    }
  }
  return result;
}

}  // namespace trivet::response
