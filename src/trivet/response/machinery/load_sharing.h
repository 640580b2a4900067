// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "trivet/assembly/assembled.h"

namespace trivet::response {

/// Static load on one mount.
struct MountLoad {
  std::string element;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< on the ground, ground axes [N]
  double bearing = 0;  ///< component along gravity [N]; negative: the mount holds the machine down
  double share = 0;    ///< fraction of the sum over all mounts; the shares sum to 1
  /// Motion of end K relative to end N under the load, element axes at N [m, rad]; for a preloaded element from its
  /// preloaded state.
  Eigen::Matrix<double, 6, 1> deflection = Eigen::Matrix<double, 6, 1>::Zero();
};

struct LoadSharing {
  std::vector<MountLoad> mounts;  ///< elements with end N on the ground or on a foundation
  double bearing_in_total = 0;    ///< [N]
};

/// Distribution of the weight and the constant forces over the mounts.
/// @throws foundation::NotComputable without gravity, without load along it, or for the reasons of static_response
[[nodiscard]] LoadSharing load_sharing(const model::System& system, const assembly::Assembled& assembled);

}  // namespace trivet::response
