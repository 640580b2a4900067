// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/design/design_rules.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "trivet/foundation/constants.h"
#include "trivet/response/steady/frequency_response.h"

namespace trivet::design {
namespace {

using foundation::infinity;

}  // namespace

std::vector<LargestAmplitude> maxima_in_band(const assembly::Assembled& assembled,
                                             const std::vector<assembly::Channel>& channels,
                                             const assembly::Loading& loading, const response::Peaks& found,
                                             std::size_t curve, const assembly::Band& band) {
  std::vector<LargestAmplitude> maxima;
  const auto consider = [&](double amplitude, double omega) { maxima.push_back({amplitude, omega}); };
  // At ω = 0 a rigid-body mode has no steady amplitude; just above, the curve shows whether it contains that mode.
  const double start = std::max(band.from, found.searched_from), end = std::isinf(band.to) ? start : band.to;
  const bool starts_late = start > band.from;
  const auto at =
      response::frequency_response(assembled, {channels[curve]}, loading,
                                   {start, end, starts_late ? std::min(10 * start, found.searched_to) : start});
  const auto amplitude_at = [&](Eigen::Index i) {
    const double size = std::abs(at.curves[0].value(i));
    return std::isnan(size) ? infinity : size;
  };
  const bool diverges = starts_late && amplitude_at(0) > 5 * amplitude_at(2);
  consider(diverges ? infinity : amplitude_at(0), band.from);
  consider(amplitude_at(1), end);
  for (const response::Extremum& t : found.turnings[curve])
    if (t.maximum && t.angular_frequency >= band.from && t.angular_frequency <= band.to)
      consider(t.amplitude, t.angular_frequency);
  for (const response::Peak& peak : found.list)
    if (peak.curve == curve && peak.angular_frequency >= band.from && peak.angular_frequency <= band.to)
      consider(peak.amplitude, peak.angular_frequency);
  const response::CurveSummary& whole = found.curves[curve];
  if (std::isinf(band.to) && whole.highest_at >= found.searched_to)
    consider(whole.highest, whole.highest_at);  // an acceleration that grows up to the end of the search
  return maxima;
}

LargestAmplitude largest_in_band(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                                 const assembly::Loading& loading, const response::Peaks& found, std::size_t curve,
                                 const assembly::Band& band) {
  LargestAmplitude largest{0, band.from};
  for (const LargestAmplitude& one : maxima_in_band(assembled, channels, loading, found, curve, band))
    if (one.amplitude > largest.amplitude) largest = one;
  return largest;
}

double margin(const DesignRule& rule, double value) {
  if (std::isnan(value)) return 0;  // an unknown value never meets a limit
  const bool stands_out = rule.kind == DesignRule::Kind::no_peak && value > rule.allowed;
  const double reached = stands_out ? (1 + rule.allowed) / (1 + value) : value > 0 ? rule.allowed / value : infinity;
  assert(reached >= 0 && "amplitudes and limits are not negative");
  return reached < 1 && reached >= 1 - on_the_limit ? 1 : reached;
}

bool meets_limit(double amplitude, double limit) {
  return margin({DesignRule::Kind::amplitude, 0, limit}, amplitude) >= 1;
}

RuleValues rule_values(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                       const assembly::Loading& loading, const response::Peaks& found, const RuleSet& set) {
  RuleValues result;
  for (const DesignRule& rule : set.rules) {
    LargestAmplitude largest{0, std::numeric_limits<double>::quiet_NaN()};
    if (rule.kind == DesignRule::Kind::amplitude) {
      largest = largest_in_band(assembled, channels, loading, found, rule.channel, set.band);
    } else {
      for (const response::Peak& peak : found.list)
        if (const double height = response::relative_prominence(peak);
            peak.curve == rule.channel && height > largest.amplitude)
          largest = {height, peak.angular_frequency};
    }
    result.values.push_back(largest.amplitude);
    result.angular_frequencies.push_back(largest.angular_frequency);
  }
  return result;
}

Governing governing(const RuleSet& set, const std::vector<double>& values) {
  std::vector<double> margins;
  assert(values.size() == set.rules.size());
  for (std::size_t r = 0; r < set.rules.size(); ++r) margins.push_back(margin(set.rules[r], values[r]));
  return governing(margins);
}

Governing governing(const std::vector<double>& margins) {
  double least = infinity;
  for (const double m : margins) least = std::min(least, m);
  for (std::size_t r = 0; r < margins.size(); ++r)
    if (const double m = margins[r]; m <= least * (1 + tie_of_margins) && (m >= 1) == (least >= 1)) return {r, least};
  return {0, infinity};
}

}  // namespace trivet::design
