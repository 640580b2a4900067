// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/spatial/types.h"

namespace trivet::spatial {

/// [v]×, so that [v]× w = v × w.
[[nodiscard]] Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v);

/// X(r) = [I −[r]×; 0 I]: displacement of the point at r from that of the origin; a wrench at r acts at the origin as
/// X(r)ᵀ w.
[[nodiscard]] Matrix6 rigid_motion(const Eigen::Vector3d& r);

/// blockdiag(R, R).
[[nodiscard]] Matrix6 both_blocks(const Eigen::Matrix3d& rotation);

/// Rotation by `angle` [rad] about `axis` (any length > 0), right-handed.
[[nodiscard]] Eigen::Matrix3d rotation_about(const Eigen::Vector3d& axis, double angle);

/// Local axes as columns, e3 along `axis`; e1 is the projection of x normal to it, or of y if |e3·x| > 0.9.
[[nodiscard]] Eigen::Matrix3d axes_along(const Eigen::Vector3d& axis);

}  // namespace trivet::spatial
