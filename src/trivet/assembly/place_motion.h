// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/assembly/assembled.h"

namespace trivet::assembly {

/// Translations and rotations as linear functions of the coordinates and of the ground coordinates in space.
struct MotionRows {
  Eigen::Matrix<double, 6, Eigen::Dynamic> on_coordinates, on_ground;
};

/// Motion of one place less that of another, along and about the columns of `axes` (ground frame). The ground moves
/// rigidly; its motion is that at the other place. Directions of nodes that are left out count as zero.
[[nodiscard]] MotionRows motion_between(const model::System& system, const Assembled& assembled, const model::Place& of,
                                        const model::Place& to, const Eigen::Matrix3d& axes);

}  // namespace trivet::assembly
