// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/solids/stl_file.h"

namespace trivet::solids {

/// An edge between two vertices, low < high, with the number of triangles that run along it upwards and downwards.
struct SurfaceEdge {
  int low, high, up, down;
};

/// Edges of all triangles with three different vertices, sorted by their vertices.
[[nodiscard]] std::vector<SurfaceEdge> surface_edges(const Eigen::Matrix3Xi& triangles);

/// A surface as CAD programs mean it: triangles that are written twice (the same vertices in the same order) count
/// once, and vertices of open edges that differ by rounding are one vertex, the first of them. Each is a warning that
/// states how many and where. A surface that is closed as it is keeps its vertices.
///
/// Two vertices differ by rounding if they are closer than 2·10⁻⁵ of the largest coordinate: most programs print six
/// digits, so two roundings of one coordinate differ by up to 10⁻⁵ of it, in each direction. At most 10⁻⁴ of the
/// size, for parts far from the origin. If the file prints a fixed number of decimals, two steps of the last one count,
/// up to 10⁻³ of the size. Two vertices of one triangle are a real edge, however short, unless they are
/// as close as two roundings to single precision (2.4·10⁻⁷): so welding closes no hole of a missing triangle.
[[nodiscard]] TriangleSurface welded_surface(TriangleSurface surface);

}  // namespace trivet::solids
