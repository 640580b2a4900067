// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/spatial/types.h"

namespace trivet::spatial {

/// Cross-product matrix: [v]× w = v × w.
[[nodiscard]] Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v);

/// Rigid-body transformation X(r) = [I −[r]×; 0 I]: displacement at r from that at the origin; a wrench w at r equals
/// X(r)ᵀ w at the origin.
[[nodiscard]] Matrix6 rigid_motion(const Eigen::Vector3d& r);

/// Block-diagonal 6×6, diag(R, R).
[[nodiscard]] Matrix6 both_blocks(const Eigen::Matrix3d& rotation);

/// Rotation by `angle` [rad] about `axis` (any length > 0), right-handed.
[[nodiscard]] Eigen::Matrix3d rotation_about(const Eigen::Vector3d& axis, double angle);

/// Local axes as columns: e3 along `axis`; e1 is x, or y if |e3·x| > 0.9, projected onto the plane normal to e3.
[[nodiscard]] Eigen::Matrix3d axes_along(const Eigen::Vector3d& axis);

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
