// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "trivet/numerics/batch/design_peaks.h"
#include "trivet/numerics/roots/designs.h"

namespace trivet::numerics {

struct DrivenPeakOptions {
  double from = 0;                                      ///< lower end of the band [rad/s]
  double to = std::numeric_limits<double>::infinity();  ///< upper end [rad/s], may be infinite
  bool count_peaks = true;
  double min_prominence = 1e-6;  ///< required prominence of a peak, as a share of its curve's highest value
};

/// Highest amplitudes and resonance peaks of every curve of every design, as `design_peaks`, for loss factors, complex
/// loads, loads and curves with powers of s = iω, and curves that differ from design to design; at most twelve
/// coordinates. From partial fractions of |y|² in ω over all 2n roots, eight designs at once
/// (docs/decisions/peaks-of-designs.md). The status is `proven`, or `undecided` where poles or bounds are not good
/// enough: no values. On one thread.
/// @throws foundation::InvalidInput for sizes that do not match, products of powers outside `least_power` …
/// `most_power` (`most_power_in_band` without peaks in a finite band), a band that is empty or negative
[[nodiscard]] DesignPeaks driven_peaks(const DrivenDesigns& designs, const DrivenPeakOptions& options = {});

}  // namespace trivet::numerics
