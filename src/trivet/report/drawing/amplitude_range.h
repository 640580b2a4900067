// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

/// The one rule for logarithmic amplitudes (docs/decisions/report-charts.md).
namespace trivet::report {

/// Amplitudes over frequency or speed, in one unit with the others of their chart. Not finite: a gap, or +∞ at an
/// undamped resonance.
struct DrawnAmplitudes {
  std::span<const double> at;         ///< ascending
  std::span<const double> amplitude;  ///< ≥ 0
};

/// Constants of the rule, which the script of the page has from here.
struct AmplitudeRule {
  double range = 100;        ///< two decades: an axis with more is logarithmic
  double dips = 0.1;         ///< share of the band in which a curve may be lower than the least amplitude that matters
  double negligible = 1e-3;  ///< a curve that nowhere reaches this share of the largest amplitude does not matter
  double round_off = 1e-8;   ///< amplitudes below this share of the largest are not amplitudes
  double below = 10;         ///< a logarithmic axis ends at most this factor below the least amplitude that matters
};
inline constexpr AmplitudeRule amplitude_rule;

/// What the curves of one chart span.
struct AmplitudeRange {
  double largest = 0;      ///< finite; 0: nothing is drawn
  double least = 0;        ///< that matters: each curve, unless negligible, exceeds it over nine tenths of its band
  double bottom = 0;       ///< of a logarithmic axis: the smallest amplitude, or `below` under the least
  bool unbounded = false;  ///< an amplitude is infinite

  /// Is the axis logarithmic? On a linear one the least amplitude that matters would be in its lowest hundredth.
  [[nodiscard]] bool is_wide() const { return largest > 0 && (unbounded || largest > amplitude_rule.range * least); }
};

[[nodiscard]] AmplitudeRange amplitude_range(const std::vector<DrawnAmplitudes>& curves);

}  // namespace trivet::report
