// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/response/steady/frequency_grid.h"
#include "trivet/response/steady/peaks.h"

namespace trivet::design {

/// Largest |y| over a band, and its frequency.
struct LargestAmplitude {
  double amplitude = 0;          ///< infinite at an undamped resonance or towards a rigid-body mode
  double angular_frequency = 0;  ///< [rad/s]; infinite if the amplitude is only approached
};

/// Amplitudes of one channel at the ends of a band and at the maxima inside. A band may reach to infinity.
/// @param found  the peaks of all `channels`; `curve` is the index of one of them
[[nodiscard]] std::vector<LargestAmplitude> maxima_in_band(const assembly::Assembled& assembled,
                                                           const std::vector<assembly::Channel>& channels,
                                                           const assembly::Loading& loading,
                                                           const response::Peaks& found, std::size_t curve,
                                                           const assembly::Band& band);

/// The largest of them.
[[nodiscard]] LargestAmplitude largest_in_band(const assembly::Assembled& assembled,
                                               const std::vector<assembly::Channel>& channels,
                                               const assembly::Loading& loading, const response::Peaks& found,
                                               std::size_t curve, const assembly::Band& band);

/// A rule that a feasible design meets.
struct DesignRule {
  enum class Kind { amplitude, no_peak, requirement };  ///< a requirement is judged elsewhere, in no RuleSet
  Kind kind = Kind::amplitude;
  std::size_t channel = 0;
  double allowed = 0;  ///< amplitude [SI], or relative prominence
};

/// A value that exceeds its limit by at most this share counts as on the limit and is feasible: heights have nine
/// digits, and equal designs must not differ by round-off.
inline constexpr double on_the_limit = 1e-9;

/// Margin of a rule: 1 on its limit, above 1 if the rule is met. Amplitude: allowed over value. No peak: allowed over
/// relative prominence if that is below, and (1 + allowed) over (1 + relative prominence) if it is above, the factor by
/// which the peak must come down; infinite without a peak.
[[nodiscard]] double margin(const DesignRule& rule, double value);

/// Is an amplitude below its limit, or on it?
[[nodiscard]] bool meets_limit(double amplitude, double limit);

struct RuleSet {
  std::vector<DesignRule> rules;
  assembly::Band band;           ///< band of the amplitudes [rad/s]; may reach to infinity
  double min_prominence = 1e-6;  ///< see PeakOptions
};

struct RuleValues {
  std::vector<double> values;  ///< of each rule: the largest amplitude in the band, or the largest relative prominence
                               ///< of a peak (0 without one)
  std::vector<double> angular_frequencies;  ///< [rad/s]; infinite if the value is only approached, NaN without a peak
};

/// The values that the rules limit.
[[nodiscard]] RuleValues rule_values(const assembly::Assembled& assembled,
                                     const std::vector<assembly::Channel>& channels, const assembly::Loading& loading,
                                     const response::Peaks& found, const RuleSet& set);

/// Margins that differ by less than this share are equal: far above the round-off of peaks, far below differences that
/// matter in a design.
inline constexpr double tie_of_margins = 1e-6;

/// The first rule with a margin within a tie of the least, so that round-off does not choose among equals; violated
/// rules before met ones.
struct Governing {
  std::size_t rule = 0;
  double margin = 0;  ///< the least of all rules
  [[nodiscard]] bool feasible() const { return margin >= 1; }
};
[[nodiscard]] Governing governing(const RuleSet& set, const std::vector<double>& values);
[[nodiscard]] Governing governing(const std::vector<double>& margins);

}  // namespace trivet::design
