// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/seen_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

namespace trivet::report {
namespace {

constexpr double sharpest_round = 0.9;  // cosine of the angle between faces of a round surface

Eigen::Vector3d face_normal(const std::vector<int>& face, const std::vector<Eigen::Vector3d>& vertices) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < face.size(); ++i) sum += vertices[face[i]].cross(vertices[face[(i + 1) % face.size()]]);
  return sum;
}

/// Between two faces; on a round surface not sharp.
struct SurfaceEdge {
  int a = 0, b = 0;
  int left = -1, right = -1;  ///< faces; −1: none
  bool sharp = true;
};

std::vector<SurfaceEdge> edges_of(const SolidSurface& surface) {
  std::map<std::pair<int, int>, SurfaceEdge> edges;
  std::vector<Eigen::Vector3d> normals;
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    const std::vector<int>& face = surface.faces[f];
    normals.push_back(face_normal(face, surface.vertices).normalized());
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int a = face[i], b = face[(i + 1) % face.size()];
      SurfaceEdge& edge = edges[std::minmax(a, b)];
      edge.a = a;
      edge.b = b;
      (edge.left < 0 ? edge.left : edge.right) = static_cast<int>(f);
    }
  }
  std::vector<SurfaceEdge> list;
  for (auto& [ends, edge] : edges) {
    edge.sharp = edge.right < 0 || !(normals[edge.left].dot(normals[edge.right]) > sharpest_round);
    list.push_back(edge);
  }
  return list;
}

}  // namespace

SeenSurface seen(const SolidSurface& surface, const Projection& projection) {
  SeenSurface result;
  const Eigen::Vector3d towards = projection.view.towards();
  constexpr double edge_on = 1e-9;  // cosine below which a face is seen as a line
  std::vector<bool> visible;
  for (const auto& face : surface.faces) {
    const Eigen::Vector3d normal = face_normal(face, surface.vertices);
    visible.push_back(normal.dot(towards) > edge_on * normal.norm());
    if (!visible.back()) continue;
    result.faces.emplace_back();
    for (const int v : face) result.faces.back().push_back(projection.at(surface.vertices[v]));
  }
  const bool edge_on_only = result.faces.empty();  // a plate without thickness
  for (const SurfaceEdge& edge : edges_of(surface)) {
    const bool left = visible[edge.left], right = edge.right >= 0 && visible[edge.right];
    if (edge_on_only || (edge.sharp ? left || right : left != right))
      result.lines.emplace_back(projection.at(surface.vertices[edge.a]), projection.at(surface.vertices[edge.b]));
  }
  return result;
}

}  // namespace trivet::report
