// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/view_projection.h"

#include <algorithm>
#include <cmath>

namespace trivet::report {

const std::array<View, 4>& four_views() {
  static const double half = std::sqrt(0.5), sixth = std::sqrt(1.0 / 6);
  static const std::array<View, 4> views = {{{"front", {1, 0, 0}, {0, 0, 1}},
                                             {"side", {0, 1, 0}, {0, 0, 1}},
                                             {"top", {1, 0, 0}, {0, 1, 0}},
                                             {"isometric", {half, half, 0}, {-sixth, sixth, 2 * sixth}}}};
  return views;
}

PixelPoint Projection::at(const Eigen::Vector3d& place) const {
  const Eigen::Vector3d d = place - centre;
  return {middle.x + scale * view.right.dot(d), middle.y - scale * view.up.dot(d)};
}

std::vector<PixelPoint> convex_hull(std::vector<PixelPoint> points) {
  std::ranges::sort(points, [](PixelPoint a, PixelPoint b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  const auto turn = [](PixelPoint o, PixelPoint a, PixelPoint b) {
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
  };
  std::vector<PixelPoint> hull;
  for (int side = 0; side < 2; ++side) {  // the lower chain, then the upper one
    const std::size_t start = hull.size();
    for (const PixelPoint& p : points) {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    if (!hull.empty()) hull.pop_back();
    std::ranges::reverse(points);
  }
  return hull;
}

}  // namespace trivet::report
