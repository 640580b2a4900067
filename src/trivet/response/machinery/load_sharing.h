// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "trivet/assembly/assembled.h"

namespace trivet::response {

/// What one mount bears of the static load.
struct MountLoad {
  std::string element;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< on the ground, ground axes [N]
  double bearing = 0;                               ///< along gravity [N]; negative: the mount holds down
  double share = 0;                                 ///< of the sum over all mounts, a fraction; sums to 1
  /// End K against N under the load, element axes at N [m, rad]; of a preloaded element from its preloaded state.
  Eigen::Matrix<double, 6, 1> deflection = Eigen::Matrix<double, 6, 1>::Zero();
};

struct LoadSharing {
  std::vector<MountLoad> mounts;  ///< elements whose end N stands on the ground or on a foundation
  double bearing_in_total = 0;    ///< [N]
};

/// Which mount carries how much of the weight and the constant forces.
/// @throws foundation::NotComputable without gravity, without load along it, or as static_response
[[nodiscard]] LoadSharing load_sharing(const model::System& system, const assembly::Assembled& assembled);

}  // namespace trivet::response
