// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/assembly/loads.h"

namespace trivet::response {

/// Steady motion of everything at one ω, zero-to-peak amplitudes.
struct SteadyMotion {
  double angular_frequency = 0;  ///< [rad/s]
  Eigen::VectorXcd free;         ///< free coordinates; of frequency-dependent elements without their internal ones
  Eigen::VectorXcd ground;       ///< ground coordinates, zero if the ground rests
};

/// At the given ω > 0 [rad/s], frequency-dependent elements by their exact laws.
/// @throws foundation::NotComputable where Z(ω) is singular: an undamped resonance
[[nodiscard]] std::vector<SteadyMotion> steady_motions(const assembly::Assembled& assembled,
                                                       const assembly::Loading& loading,
                                                       const std::vector<double>& angular_frequency);

/// End displacements (12, local frame) and internal coordinates of an element in a steady motion; of a
/// frequency-dependent one the 12 alone.
[[nodiscard]] Eigen::VectorXcd element_motion(const assembly::ElementMap& map, const SteadyMotion& motion);

/// What moves the ends so: wrenches on the element at N and K (first 12), local frame; behind them forces on internal
/// coordinates, zero in a free steady motion.
[[nodiscard]] Eigen::VectorXcd element_wrenches(const assembly::ElementMap& map, const Eigen::VectorXcd& element_motion,
                                                double angular_frequency);

}  // namespace trivet::response
