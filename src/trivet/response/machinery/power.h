// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "trivet/assembly/loads.h"
#include "trivet/foundation/interruption.h"

namespace trivet::response {

/// Mean power in the steady state [W], columns over ω. All signs as the words say; negative: the other way.
/// by_forces + by_ground = Σ dissipated + dissipated_by_foundations + dissipated_by_system.
struct PowerFlow {
  std::vector<double> angular_frequency;  ///< [rad/s]
  std::vector<std::string> mounts;        ///< elements whose end N stands on the ground or on a foundation
  /// mounts × ω: ½ Re(F · conj v) of the wrench on the ground at the foot and the foot's velocity
  Eigen::MatrixXd into_ground;
  Eigen::VectorXd into_ground_in_total;  ///< their sum
  Eigen::VectorXd by_forces;             ///< fed in by forces on bodies
  Eigen::VectorXd by_ground;             ///< fed in by driven ground ends; what the rigid ground takes is its negative
  std::vector<std::string> elements;     ///< all, also those without damping
  Eigen::MatrixXd dissipated;            ///< elements × ω: ½ ω Im(dᴴ D(ω) d)
  Eigen::VectorXd dissipated_by_foundations;  ///< in impedances of ground that gives
  Eigen::VectorXd dissipated_by_system;       ///< taken from the bodies by Rayleigh or modal damping
};

/// @throws foundation::NotComputable where Z(ω) is singular
[[nodiscard]] PowerFlow power_flow(const model::System& system, const assembly::Assembled& assembled,
                                   const assembly::Loading& loading, const std::vector<double>& angular_frequency,
                                   const foundation::Progress& progress = {});

}  // namespace trivet::response
