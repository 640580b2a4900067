// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "trivet/assembly/loads.h"
#include "trivet/foundation/interruption.h"

namespace trivet::response {

/// Mean power in the steady state [W], columns over ω; positive in the direction that the name states.
/// by_forces + by_ground = Σ dissipated + dissipated_by_foundations + dissipated_by_system.
struct PowerFlow {
  std::vector<double> angular_frequency;  ///< [rad/s]
  std::vector<std::string> mounts;        ///< elements with end N on the ground or on a foundation
  /// mounts × ω: ½ Re(F · conj v) with the wrench F on the ground at the foot and the velocity v of the foot
  Eigen::MatrixXd into_ground;
  Eigen::VectorXd into_ground_in_total;       ///< sum over the mounts
  Eigen::VectorXd by_forces;                  ///< fed in by forces on bodies
  Eigen::VectorXd by_ground;                  ///< fed in by driven ground ends; the rigid ground absorbs its negative
  std::vector<std::string> elements;          ///< all, including those without damping
  Eigen::MatrixXd dissipated;                 ///< elements × ω: ½ ω Im(dᴴ D(ω) d)
  Eigen::VectorXd dissipated_by_foundations;  ///< in impedances of flexible foundations
  Eigen::VectorXd dissipated_by_system;       ///< taken from the bodies by Rayleigh or modal damping
};

/// @throws foundation::NotComputable if Z(ω) is singular
[[nodiscard]] PowerFlow power_flow(const model::System& system, const assembly::Assembled& assembled,
                                   const assembly::Loading& loading, const std::vector<double>& angular_frequency,
                                   const foundation::Progress& progress = {});

}  // namespace trivet::response
