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

}  // namespace trivet::spatial
