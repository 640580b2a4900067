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

}  // namespace trivet::solids
