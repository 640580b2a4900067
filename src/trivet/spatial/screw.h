// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/spatial/types.h"

namespace trivet::spatial {

/// A small rigid motion as a screw: rotation about a line and translation along it.
struct Screw {
  bool pure_translation = true;                         ///< no rotation: `point` and `pitch` are undefined
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< unit vector along the axis, or along the translation
  Eigen::Vector3d point = Eigen::Vector3d::Zero();      ///< point of the axis nearest to `about` [m]
  double pitch = 0;                                     ///< translation along the axis per rotation [m/rad]
  double rotation = 0;                                  ///< amount of rotation [rad]
};

/// Screw of a motion given at the origin. `length` [m] is a size of the body: a rotation is neglected if angle · length
/// is at most 1e-9 of the translation. The axis point is the one nearest to `about`.
[[nodiscard]] Screw screw(const Displacement& at_origin, double length, const Eigen::Vector3d& about);

}  // namespace trivet::spatial
