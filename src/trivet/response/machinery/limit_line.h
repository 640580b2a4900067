// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "trivet/assembly/limit_line.h"
#include "trivet/response/steady/frequency_grid.h"

namespace trivet::response {

/// Zero-to-peak limit at ω within the line.
[[nodiscard]] double zero_to_peak_limit(const assembly::LimitLine& line, double angular_frequency);

/// Comparison of a result with a limit line in the band where both are defined.
struct LimitComparison {
  assembly::Band compared;                ///< [rad/s]: the part of the band that the line covers
  std::vector<double> angular_frequency;  ///< frequencies of `margin` [rad/s]
  Eigen::VectorXd margin;                 ///< limit / level: ≥ 1 meets the limit; infinite if the level is 0
  double least_margin = std::numeric_limits<double>::infinity();  ///< 0 at an undamped resonance
  double least_margin_at = 0;                                     ///< [rad/s]
  std::vector<assembly::Band> exceeded;  ///< [rad/s], ends by root search on the exact response
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
                                                  const assembly::LimitLine& line, const assembly::Band& band,
                                                  const foundation::Progress& progress = {});

/// Margin level 20 lg(margin) [dB]; positive if the limit is met.
[[nodiscard]] double margin_level(double margin);

}  // namespace trivet::response
