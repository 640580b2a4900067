// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "trivet/foundation/problems.h"
#include "trivet/response/steady/frequency_grid.h"

namespace trivet::response {

/// A limit over frequency: straight between its points on logarithmic axes, not defined outside. Two equal frequencies
/// are a step; there the lower value holds.
struct LimitLine {
  std::string name;
  std::string unit;                       ///< SI, of the answer it limits: "m", "m/s", "m/s²", "N" …
  bool rms = true;                        ///< root mean square; otherwise zero-to-peak
  std::vector<double> angular_frequency;  ///< [rad/s] > 0, ascending
  std::vector<double> limit;              ///< > 0
};

/// All that is wrong with the table; subject is its path in the project.
[[nodiscard]] foundation::Problems check(const LimitLine& line, const std::string& subject);

/// Zero-to-peak limit at ω within the line.
[[nodiscard]] double zero_to_peak_limit(const LimitLine& line, double angular_frequency);

/// An answer against a limit line, where both are known.
struct LimitComparison {
  Band compared;                          ///< [rad/s]: the part of the band that the line covers
  std::vector<double> angular_frequency;  ///< of `margin` [rad/s]
  Eigen::VectorXd margin;                 ///< limit over level: ≥ 1 keeps it; infinite where nothing moves
  double least_margin = std::numeric_limits<double>::infinity();  ///< 0 at an undamped resonance
  double least_margin_at = 0;                                     ///< [rad/s]
  std::vector<Band> exceeded;  ///< [rad/s], ends by root search on the exact response
  [[nodiscard]] bool kept() const { return exceeded.empty(); }
};

/// Looks on the automatic grid with all extrema of the answer and all points of the line, and from there by root and
/// minimum search.
/// @param peaks  of `channel` alone under this loading
/// @throws foundation::InvalidInput if the units differ or the line has errors; NotComputable if line and band have no
/// part in common
[[nodiscard]] LimitComparison compared_with_limit(const assembly::Assembled& assembled,
                                                  const assembly::Channel& channel, const assembly::Loading& loading,
                                                  const Eigen::VectorXcd& poles, const Peaks& peaks,
                                                  const LimitLine& line, const Band& band,
                                                  const foundation::Progress& progress = {});

/// 20 lg of a margin [dB]: positive keeps the limit.
[[nodiscard]] double margin_level(double margin);

}  // namespace trivet::response
