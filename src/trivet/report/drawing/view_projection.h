// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "trivet/report/drawing/svg_canvas.h"
#include "trivet/results/scene/drawn_machine.h"

namespace trivet::report {

using results::Bounds;
using results::DrawnMachine;
using results::SolidSurface;

/// Direction from which a machine is drawn: the unit vectors of the paper in the ground frame.
struct View {
  const char* name;
  Eigen::Vector3d right, up;

  /// Towards the viewer.
  [[nodiscard]] Eigen::Vector3d towards() const { return right.cross(up); }
};

/// Front (from −y), side (from +x), top (from +z) and isometric (from +x, −y, +z), in third-angle projection.
[[nodiscard]] const std::array<View, 4>& four_views();

/// Parallel projection of places in the ground frame [m] onto a canvas [pixels].
struct Projection {
  View view;
  double scale = 1;                                  ///< [pixels/m]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< the place that is drawn at `middle` [m]
  PixelPoint middle;

  [[nodiscard]] PixelPoint at(const Eigen::Vector3d& place) const;
};

/// Corners of the convex hull of points on the paper, in order around it.
[[nodiscard]] std::vector<PixelPoint> convex_hull(std::vector<PixelPoint> points);

}  // namespace trivet::report
