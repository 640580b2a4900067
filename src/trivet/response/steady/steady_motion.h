// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

#include "trivet/assembly/loads.h"
#include "trivet/numerics/sweep/frequency_sweep.h"

namespace trivet::response {

/// Coordinates at the given real ω ≥ 0 [rad/s], one column each, with the exact laws of frequency-dependent elements
/// (then only the first rows of the layout); NaN if Z(ω) is singular.
[[nodiscard]] numerics::SweepResult steady_solution(const assembly::Assembled& assembled,
                                                    const assembly::Loading& loading,
                                                    const std::vector<double>& angular_frequency,
                                                    const numerics::SweepOptions& options = {});

/// Steady motion of all coordinates at one ω, zero-to-peak amplitudes.
struct SteadyMotion {
  double angular_frequency = 0;  ///< [rad/s]
  Eigen::VectorXcd free;         ///< free coordinates, without the internal ones of frequency-dependent elements
  Eigen::VectorXcd ground;       ///< ground coordinates, zero if the ground is at rest
};

/// Motions at the given ω > 0 [rad/s], with the exact laws of frequency-dependent elements.
/// @throws foundation::NotComputable if Z(ω) is singular: an undamped resonance
[[nodiscard]] std::vector<SteadyMotion> steady_motions(const assembly::Assembled& assembled,
                                                       const assembly::Loading& loading,
                                                       const std::vector<double>& angular_frequency);

/// End displacements (12, local frame) and internal coordinates of an element in a steady motion; for a
/// frequency-dependent one the 12 alone.
[[nodiscard]] Eigen::VectorXcd element_motion(const assembly::ElementMap& map, const SteadyMotion& motion);

/// Wrenches on the element at N and K (first 12), local frame, that cause this motion; then forces on internal
/// coordinates, zero in a free steady motion.
[[nodiscard]] Eigen::VectorXcd element_wrenches(const assembly::ElementMap& map, const Eigen::VectorXcd& element_motion,
                                                double angular_frequency);

}  // namespace trivet::response
