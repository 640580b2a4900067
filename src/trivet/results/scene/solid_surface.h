// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "trivet/solids/rigid_solid.h"
#include "trivet/spatial/mass_properties.h"

namespace trivet::results {

/// The surface of a solid as polygons.
struct SolidSurface {
  std::vector<Eigen::Vector3d> vertices;  ///< [m]
  std::vector<std::vector<int>> faces;    ///< convex; vertices counterclockwise, seen from outside
};

/// Box with its middle at the origin. @param half  half lengths [m]
[[nodiscard]] SolidSurface box_surface(const Eigen::Vector3d& half);

/// Surface of a solid in the frame of its body; empty for an STL file that cannot be read, and for a STEP file that
/// gmsh cannot mesh.
[[nodiscard]] std::optional<SolidSurface> surface_of(const solids::Part& part);

/// A homogeneous box.
struct EquivalentBox {
  Eigen::Vector3d centre;
  Eigen::Matrix3d axes;  ///< columns, right-handed
  Eigen::Vector3d half;  ///< half lengths [m]; 0 where an unphysical inertia gives none

  [[nodiscard]] SolidSurface surface() const;
};
/// The box with this mass, centre and inertia, in body axes: half lengths √(3/2 (J_b + J_c − J_a) / m) along the
/// principal axes.
[[nodiscard]] EquivalentBox equivalent_box(const spatial::MassProperties& mass);

/// The same surface with fewer faces: its vertices in the cells of a cubic lattice become one, their mean, and faces
/// that lose a corner go. The surface moves by less than the diagonal of a cell.
/// @param most  triangles in the result
[[nodiscard]] SolidSurface coarsened(const SolidSurface& triangles, std::size_t most);

}  // namespace trivet::results
