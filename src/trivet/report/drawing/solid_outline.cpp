// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/solid_outline.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/solids/welded_surface.h"

namespace trivet::report {
namespace {

constexpr double sharpest_round = 0.9;  // cosine of the angle between faces of a round surface

Eigen::Vector3d face_normal(const std::vector<int>& face, const std::vector<Eigen::Vector3d>& vertices) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < face.size(); ++i) sum += vertices[face[i]].cross(vertices[face[(i + 1) % face.size()]]);
  return sum;
}

void find_edges(SolidOutline& outline) {
  std::map<std::pair<int, int>, SolidOutline::Edge> edges;
  std::vector<Eigen::Vector3d> normals;
  for (std::size_t f = 0; f < outline.faces.size(); ++f) {
    const std::vector<int>& face = outline.faces[f];
    normals.push_back(face_normal(face, outline.vertices).normalized());
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int a = face[i], b = face[(i + 1) % face.size()];
      SolidOutline::Edge& edge = edges[std::minmax(a, b)];
      edge.a = a;
      edge.b = b;
      (edge.left < 0 ? edge.left : edge.right) = static_cast<int>(f);
    }
  }
  for (auto& [ends, edge] : edges) {
    edge.sharp = edge.right < 0 || !(normals[edge.left].dot(normals[edge.right]) > sharpest_round);
    outline.edges.push_back(edge);
  }
}

/// A circle of a surface of revolution about z.
struct Ring {
  double z, radius;
};

SolidOutline turned_outline(const std::vector<Ring>& rings) {
  constexpr int corners = 36;
  SolidOutline outline;
  for (const Ring& ring : rings)
    for (int i = 0; i < corners; ++i) {
      const double angle = foundation::two_pi * i / corners;
      outline.vertices.emplace_back(ring.radius * std::cos(angle), ring.radius * std::sin(angle), ring.z);
    }
  std::vector<int> bottom, top;
  const int last = corners * (static_cast<int>(rings.size()) - 1);
  for (int i = 0; i < corners; ++i) {
    bottom.push_back(corners - 1 - i);
    top.push_back(last + i);
  }
  outline.faces = {bottom, top};
  for (int start = 0; start < last; start += corners)
    for (int i = 0; i < corners; ++i) {
      const int next = (i + 1) % corners;
      outline.faces.push_back({start + i, start + next, start + corners + next, start + corners + i});
    }
  find_edges(outline);
  return outline;
}

SolidOutline sphere_outline(double radius) {
  constexpr int belts = 18;
  std::vector<Ring> rings;
  for (int i = 0; i <= belts; ++i) {
    const double angle = foundation::two_pi / 2 * i / belts;
    rings.push_back({-radius * std::cos(angle), radius * std::sin(angle)});
  }
  return turned_outline(rings);
}

std::optional<SolidOutline> file_outline(const solids::StlSolid& stl) {
  const auto read = solids::read_stl(stl.file);
  if (!read) return std::nullopt;
  const solids::TriangleSurface surface = solids::welded_surface(*read);
  SolidOutline outline;
  for (Eigen::Index v = 0; v < surface.vertices.cols(); ++v)
    outline.vertices.emplace_back(surface.vertices.col(v) * stl.length_unit);
  for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) {
    const auto corners = surface.triangles.col(t);
    outline.faces.push_back({corners(0), corners(1), corners(2)});
  }
  find_edges(outline);
  return outline;
}

struct OutlineOf {
  std::optional<SolidOutline> operator()(const solids::Box& b) const {
    return box_outline(Eigen::Vector3d(b.length_x, b.length_y, b.length_z) / 2);
  }
  std::optional<SolidOutline> operator()(const solids::Cylinder& c) const {
    return turned_outline({{-c.length / 2, c.diameter / 2}, {c.length / 2, c.diameter / 2}});
  }
  std::optional<SolidOutline> operator()(const solids::Tube& t) const {  // outside, and back through the hole
    const double outer = t.outer_diameter / 2, inner = t.inner_diameter / 2, end = t.length / 2;
    SolidOutline outline = turned_outline({{-end, inner}, {-end, outer}, {end, outer}, {end, inner}, {-end, inner}});
    outline.faces.erase(outline.faces.begin(), outline.faces.begin() + 2);  // the hole is open
    outline.edges.clear();
    const int first = 4 * static_cast<int>(outline.vertices.size()) / 5;  // the last ring is the first one
    for (auto& face : outline.faces)
      for (int& vertex : face) vertex -= vertex >= first ? first : 0;
    outline.vertices.resize(static_cast<std::size_t>(first));
    find_edges(outline);
    return outline;
  }
  std::optional<SolidOutline> operator()(const solids::Sphere& s) const { return sphere_outline(s.diameter / 2); }
  std::optional<SolidOutline> operator()(const solids::Cone& c) const {
    return turned_outline({{-c.length / 2, c.start_diameter / 2}, {c.length / 2, c.end_diameter / 2}});
  }
  std::optional<SolidOutline> operator()(const solids::StlSolid& stl) const { return file_outline(stl); }
  std::optional<SolidOutline> operator()(const solids::StepSolid&) const { return std::nullopt; }
};

}  // namespace

SolidOutline box_outline(const Eigen::Vector3d& half) {
  SolidOutline outline;
  for (int corner = 0; corner < 8; ++corner)
    outline.vertices.emplace_back(half.x() * (corner & 1 ? 1 : -1), half.y() * (corner & 2 ? 1 : -1),
                                  half.z() * (corner & 4 ? 1 : -1));
  outline.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  find_edges(outline);
  return outline;
}

std::optional<SolidOutline> outline_of(const solids::Part& part) {
  std::optional<SolidOutline> outline = std::visit(OutlineOf(), part.shape);
  if (outline)
    for (Eigen::Vector3d& v : outline->vertices) v = part.pose.position + part.pose.rotation * v;
  return outline;
}

SolidOutline equivalent_box(const spatial::MassProperties& mass) {
  const spatial::PrincipalInertia inertia = spatial::principal_inertia(mass);
  const Eigen::Vector3d second = Eigen::Vector3d::Constant(inertia.moments.sum()) - 2 * inertia.moments;
  SolidOutline outline = box_outline((1.5 * second.cwiseMax(0) / mass.mass).cwiseSqrt());
  for (Eigen::Vector3d& v : outline.vertices) v = mass.centre + inertia.axes * v;
  if (inertia.axes.determinant() < 0)  // a reflected box is inside out
    for (auto& face : outline.faces) std::ranges::reverse(face);
  return outline;
}

SeenOutline seen(const SolidOutline& outline, const std::vector<Eigen::Vector3d>& vertices,
                 const Projection& projection) {
  SeenOutline result;
  const Eigen::Vector3d towards = projection.view.towards();
  constexpr double edge_on = 1e-9;  // cosine below which a face is seen as a line
  std::vector<bool> visible;
  for (const auto& face : outline.faces) {
    const Eigen::Vector3d normal = face_normal(face, vertices);
    visible.push_back(normal.dot(towards) > edge_on * normal.norm());
    if (!visible.back()) continue;
    result.faces.emplace_back();
    for (const int v : face) result.faces.back().push_back(projection.at(vertices[v]));
  }
  const bool edge_on_only = result.faces.empty();  // a plate without thickness
  for (const SolidOutline::Edge& edge : outline.edges) {
    const bool left = visible[edge.left], right = edge.right >= 0 && visible[edge.right];
    if (edge_on_only || (edge.sharp ? left || right : left != right))
      result.lines.emplace_back(projection.at(vertices[edge.a]), projection.at(vertices[edge.b]));
  }
  return result;
}

}  // namespace trivet::report
