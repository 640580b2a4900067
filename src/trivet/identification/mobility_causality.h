// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace trivet::identification {

/// Verdict on whether a passive, causal structure can have a mobility.
struct MobilityVerdict {
  double relative_rms = 0;  ///< distance from the nearest such mobility, rms of the relative distance over the rows
  bool passes = true;       ///< the distance is within noise
  bool too_coarse = false;  ///< only resonances narrower than the row spacing explain it
  bool refused = false;     ///< the distance is so large that the phase must be wrong
};

/// The driving-point mobility of any passive linear structure, with any damping, is a sum with weights ≥ 0 of a mass, a
/// spring, a dashpot and sections of second order (passive_sections.h). The nearest sum with sections that the rows can
/// resolve is found by non-negative least squares on relative distances.
/// @param angular_frequencies  [rad/s] > 0, increasing
/// @param mobility             [(m/s)/N], not 0
[[nodiscard]] MobilityVerdict mobility_causality(const std::vector<double>& angular_frequencies,
                                                 const Eigen::VectorXcd& mobility);

}  // namespace trivet::identification
