// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/solids/surface_edges.h"

#include <algorithm>
#include <tuple>

#include "trivet/foundation/index.h"

namespace trivet::solids {

std::vector<SurfaceEdge> surface_edges(const Eigen::Matrix3Xi& triangles) {
  std::vector<SurfaceEdge> all;
  all.reserve(3 * to_size(triangles.cols()));
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    if (triangles(0, t) == triangles(1, t) || triangles(1, t) == triangles(2, t) || triangles(2, t) == triangles(0, t))
      continue;  // a line at most
    for (int j = 0; j < 3; ++j) {
      const int from = triangles(j, t), to = triangles((j + 1) % 3, t);
      all.push_back({std::min(from, to), std::max(from, to), from<to, from> to});
    }
  }
  std::ranges::sort(all, [](const SurfaceEdge& a, const SurfaceEdge& b) {
    return std::tie(a.low, a.high) < std::tie(b.low, b.high);
  });
  std::vector<SurfaceEdge> merged;
  for (const SurfaceEdge& edge : all) {
    if (!merged.empty() && merged.back().low == edge.low && merged.back().high == edge.high)
      merged.back().up += edge.up, merged.back().down += edge.down;
    else merged.push_back(edge);
  }
  return merged;
}

}  // namespace trivet::solids
