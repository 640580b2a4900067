// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "trivet/report/drawing/view_projection.h"
#include "trivet/solids/rigid_solid.h"
#include "trivet/spatial/mass_properties.h"

namespace trivet::report {

/// The surface of a solid as polygons, and the edges between them.
struct SolidOutline {
  /// Between two faces; on a round surface not sharp.
  struct Edge {
    int a = 0, b = 0;
    int left = -1, right = -1;  ///< faces; −1: none
    bool sharp = true;
  };
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::vector<int>> faces;  ///< vertices counterclockwise, seen from outside
  std::vector<Edge> edges;
};

/// Box with its middle at the origin. @param half  half lengths [m]
[[nodiscard]] SolidOutline box_outline(const Eigen::Vector3d& half);

/// Outline of a solid in the frame of its body; empty for a STEP file, and for an STL file that cannot be read.
[[nodiscard]] std::optional<SolidOutline> outline_of(const solids::Part& part);

/// The homogeneous box with this mass, centre and inertia, in body axes: half lengths √(3/2 (J_b + J_c − J_a) / m)
/// along the principal axes; 0 where an unphysical inertia gives none.
[[nodiscard]] SolidOutline equivalent_box(const spatial::MassProperties& mass);

/// What is seen of an outline: the area that it covers, and lines.
struct SeenOutline {
  std::vector<std::vector<PixelPoint>> faces;  ///< those towards the viewer
  std::vector<std::pair<PixelPoint, PixelPoint>> lines;
};
/// @param vertices  of the outline, in the ground frame
[[nodiscard]] SeenOutline seen(const SolidOutline& outline, const std::vector<Eigen::Vector3d>& vertices,
                               const Projection& projection);

}  // namespace trivet::report
