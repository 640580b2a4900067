// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/peaks.h"

#include <algorithm>
#include <cmath>

#include "trivet/assembly/coordinates.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/peaks/circle_search.h"
#include "trivet/numerics/peaks/disc_search.h"
#include "trivet/numerics/peaks/peak_count.h"
#include "trivet/numerics/peaks/peak_refinement.h"
#include "trivet/response/steady/exact_response.h"
#include "trivet/response/steady/frequency_response.h"

namespace trivet::response {
namespace {

using Complex = std::complex<double>;
using foundation::infinity;

bool defined_at_rest(const assembly::Assembled& assembled) {
  return std::ranges::all_of(assembled.elements, [](const assembly::ElementMap& map) { return map.defined_from == 0; });
}

/// End of the search. Frequency-dependent elements have no last pole: it is where the caller requests it, but well
/// above the natural frequencies. Tables (a mobility with its own resonances) are searched to their end, unless that is
/// far above.
double search_end(const assembly::Assembled& assembled, const modal::Modes& modes, const modal::Roots& roots,
                  const PeakOptions& options) {
  constexpr double well_above = 2, far_above = 30;
  double highest = 0;
  for (const modal::Mode& mode : modes.list) highest = std::max(highest, mode.angular_frequency.value_or(0));
  for (const modal::Root& root : roots.list)
    highest = std::max(highest, root.exact ? root.damped_angular_frequency.value_or(0) : 0);
  double table_end = infinity;
  for (const assembly::ElementMap& map : assembled.elements) table_end = std::min(table_end, map.defined_to);
  const double above = std::isfinite(table_end) ? far_above : well_above;
  return std::min(table_end, std::max(options.search_to, above * highest));
}

/// Searches with samples on circles, in the range where every element is defined.
numerics::AxisSearch search_exact(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                                  const assembly::Loading& loading, const Eigen::VectorXcd& near_poles, double end,
                                  const foundation::Progress& progress) {
  constexpr double start_share = 1e-3,
                   oscillating = 1e-9;  // the latter of |λ|: less is round-off of an overdamped root
  double from = 0, smallest = end;
  std::vector<double> seams;
  for (const Complex& pole : near_poles)
    if (std::abs(pole.imag()) > oscillating * std::abs(pole)) smallest = std::min(smallest, std::abs(pole));
  for (const assembly::ElementMap& map : assembled.elements) {
    from = std::max(from, map.defined_from);
    seams.insert(seams.end(), map.knots.begin(), map.knots.end());
  }
  if (from == 0) from = start_share * smallest;
  const auto curves = to_index(channels.size());
  if (loading.vanishes() || !(end > from)) return {std::vector<numerics::SearchedCurve>(channels.size()), from, end, 0};
  const ExactResponse exact(assembled, channels, loading);
  const std::vector<numerics::ObservedCurve> observed = assembly::curves(channels);
  const Eigen::VectorXd unit = numerics::unit_scale(assembled.constant);
  return numerics::search_by_circles(
      [&](Complex omega, double near) {
        ExactSample sample = exact.at(omega, near);
        const Eigen::VectorXd together = sample.coordinates.cwiseAbs().cwiseQuotient(unit).maxCoeff() * unit;
        const Eigen::VectorXd ground =
            loading.motion.vanishes() ? Eigen::VectorXd() : Eigen::VectorXd(loading.motion.possible(std::abs(omega)));
        Eigen::VectorXd alike(curves);
        for (Eigen::Index c = 0; c < curves; ++c)
          alike(c) = numerics::possible_amplitudes(observed[c], together, ground,
                                                   Eigen::RowVectorXd::Constant(1, std::abs(omega)))
                         .value();
        return numerics::CurveSample{std::move(sample.values), std::move(sample.possible), std::move(alike),
                                     sample.condition};
      },
      curves,
      {.from = from,
       .to = end,
       .seams = std::move(seams),
       .near_poles = near_poles,
       .progress = progress,
       .name = [&](Eigen::Index c) { return channels[c].name; }});
}

/// Peaks of channels in the coordinates of the loading.
Peaks searched(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
               const assembly::Loading& loading, const modal::Modes& modes, const modal::Roots& roots,
               const PeakOptions& options, const foundation::Progress& progress) {
  const bool loaded = !loading.vanishes(), exact = assembled.frequency_dependent();
  const double end = search_end(assembled, modes, roots, options);
  const numerics::Load right_side = assembly::right_side(assembled, loading);
  const assembly::GivenCurves given = assembly::given_curves(channels, loading.motion);
  const numerics::DrivenSystem system{assembled.matrices, right_side, given.given};  // constant elements
  const foundation::Progress first_half = [&](std::string_view task, double fraction) {
    foundation::report_progress(progress, task, 0.5 * fraction);
  };
  numerics::AxisSearch found = exact
      ? search_exact(assembled, channels, loading, roots.poles, end, first_half)
      : numerics::search_by_discs(system, given.curves, roots.poles,
                                  {.to = loading.longest_delay() > 0 ? end : infinity, .progress = first_half});
  const numerics::PeakRefinement refinement(system);
  Peaks result;
  result.searched_from = found.from;
  result.searched_to = found.to;
  result.panels = found.panels;
  result.from_circles = exact;
  result.turnings.resize(channels.size());

  const int lowest_power =
      exact ? loading.lowest_power() : std::min(right_side.lowest_power(), given.given.lowest_power());
  const bool rigid = modal::has_rigid_motion(modes) || lowest_power < 0 || (!exact && found.from > 0);
  const bool rests = !rigid && defined_at_rest(assembled);
  if (exact && rests) {  // circles cannot reach ω = 0
    const FrequencyResponse at_rest = frequency_response(assembled, channels, loading, {0.0});
    for (std::size_t c = 0; c < channels.size(); ++c) found.curves[c].at_start = std::abs(at_rest.curves[c].value(0));
  }
  for (std::size_t c = 0; c < channels.size(); ++c) {
    CurveSummary& summary =
        result.curves.emplace_back(CurveSummary{channels[c].name, channels[c].unit, {}, 0, 0, false, 0});
    numerics::SearchedCurve& curve = found.curves[c];
    if (rests && std::isfinite(curve.at_start)) summary.static_amplitude = curve.at_start;
    summary.vanishes = !loaded || curve.largest_share <= numerics::vanishing_share;
    if (summary.vanishes) continue;
    const numerics::CurveHeights heights = numerics::heights_of(curve, found.from, found.to, !rigid);
    summary.highest = heights.highest;
    summary.highest_at = heights.highest_at;
    result.turnings[c] = std::move(curve.extrema);
    for (std::size_t i = 0; i < result.turnings[c].size(); ++i) {
      const Extremum& t = result.turnings[c][i];
      if (!t.maximum) continue;
      foundation::report_progress(progress, "peaks",
                                  0.5 + 0.5 * static_cast<double>(c) / static_cast<double>(channels.size()));
      Peak peak{
          c,    t.angular_frequency, t.amplitude, numerics::prominence(heights.along, i + 1), {}, {}, t.uncertainty, 0,
          false};
      if (!(peak.prominence > options.min_prominence * heights.finite_top)) continue;
      if (std::isfinite(t.amplitude)) {
        const numerics::RefinedPeak refined = exact
            ? numerics::RefinedPeak{t.angular_frequency, t.amplitude, t.uncertainty,
                                    numerics::circle_accuracy * t.amplitude, true}
            : options.refine ? refinement.refined(given.curves[c], t.angular_frequency, t.reach)
                             : numerics::RefinedPeak{};
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
      if (summary.static_amplitude && *summary.static_amplitude > numerics::vanishing_share * peak.amplitude)
        peak.ratio_to_static = peak.amplitude / *summary.static_amplitude;
      ++summary.peaks;
      result.list.push_back(peak);
    }
  }
  return result;
}

}  // namespace

double relative_prominence(const Peak& peak) {
  constexpr double round_off = 1e-13;  // a difference this small has no digits, and is a minimum of 0
  const double minimum = peak.amplitude - peak.prominence;
  return std::isinf(peak.amplitude) || !(minimum > round_off * peak.amplitude) ? infinity : peak.prominence / minimum;
}

Peaks peaks(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
            const assembly::Loading& loading, const modal::Modes& modes, const modal::Roots& roots,
            const PeakOptions& options, const foundation::Progress& progress) {
  const std::vector<assembly::ChannelGroup> groups = assembly::by_coordinates(assembled.ground, channels, loading);
  if (groups.size() == 1) return searched(assembled, channels, groups[0].loading, modes, roots, options, progress);
  Peaks result;
  result.curves.resize(channels.size());
  result.turnings.resize(channels.size());
  for (const assembly::ChannelGroup& group : groups) {
    Peaks part = searched(assembled, group.channels, group.loading, modes, roots, options, progress);
    result.searched_from = std::max(result.searched_from, part.searched_from);
    result.searched_to = std::min(result.searched_to, part.searched_to);
    result.from_circles = part.from_circles;
    result.panels += part.panels;
    for (Peak& peak : part.list) {
      peak.curve = group.which[peak.curve];
      result.list.push_back(peak);
    }
    for (std::size_t k = 0; k < group.which.size(); ++k) {
      result.curves[group.which[k]] = std::move(part.curves[k]);
      result.turnings[group.which[k]] = std::move(part.turnings[k]);
    }
  }
  std::ranges::stable_sort(result.list, {}, &Peak::curve);
  return result;
}

}  // namespace trivet::response
