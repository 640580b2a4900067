// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "trivet/foundation/problems.h"
#include "trivet/response/steady/frequency_grid.h"

namespace trivet::response {

/// A limit over frequency: straight lines between its points on logarithmic axes, undefined outside them. Two points of
/// equal frequency form a step; there the lower limit applies.
struct LimitLine {
  std::string name;
  std::string unit;                       ///< SI, of the result it limits: "m", "m/s", "m/s²", "N" …
  bool rms = true;                        ///< root mean square; otherwise zero-to-peak
  std::vector<double> angular_frequency;  ///< [rad/s] > 0, ascending
  std::vector<double> limit;              ///< > 0
};

/// All errors of the table; `subject` is its path in the project.
[[nodiscard]] foundation::Problems check(const LimitLine& line, const std::string& subject);

/// Zero-to-peak limit at ω within the line.
[[nodiscard]] double zero_to_peak_limit(const LimitLine& line, double angular_frequency);

/// Comparison of a result with a limit line in the band where both are defined.
struct LimitComparison {
  Band compared;                          ///< [rad/s]: the part of the band that the line covers
  std::vector<double> angular_frequency;  ///< frequencies of `margin` [rad/s]
  Eigen::VectorXd margin;                 ///< limit / level: ≥ 1 meets the limit; infinite if the level is 0
  double least_margin = std::numeric_limits<double>::infinity();  ///< 0 at an undamped resonance
  double least_margin_at = 0;                                     ///< [rad/s]
  std::vector<Band> exceeded;  ///< [rad/s], ends by root search on the exact response
  [[nodiscard]] bool met() const { return exceeded.empty(); }
};

/// Evaluates the margin on the automatic grid with all extrema of the result and all points of the line, then refines
/// by root and minimum search.
/// @param peaks  peaks of `channel` alone under this loading
/// @throws foundation::InvalidInput if the units differ or the line has errors; NotComputable if line and band do not
/// overlap
[[nodiscard]] LimitComparison compared_with_limit(const assembly::Assembled& assembled,
                                                  const assembly::Channel& channel, const assembly::Loading& loading,
                                                  const Eigen::VectorXcd& poles, const Peaks& peaks,
                                                  const LimitLine& line, const Band& band,
                                                  const foundation::Progress& progress = {});

/// Margin level 20 lg(margin) [dB]; positive if the limit is met.
[[nodiscard]] double margin_level(double margin);

}  // namespace trivet::response
