// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/scene/solid_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/results/scene/bounds.h"
#include "trivet/solids/step_surface.h"
#include "trivet/solids/welded_surface.h"

namespace trivet::results {
namespace {

/// A circle of a surface of revolution about z.
struct Ring {
  double z, radius;
};

SolidSurface turned_surface(const std::vector<Ring>& rings) {
  constexpr int corners = 36;
  SolidSurface surface;
  for (const Ring& ring : rings)
    for (int i = 0; i < corners; ++i) {
      const double angle = foundation::two_pi * i / corners;
      surface.vertices.emplace_back(ring.radius * std::cos(angle), ring.radius * std::sin(angle), ring.z);
    }
  std::vector<int> bottom, top;
  const int last = corners * (static_cast<int>(rings.size()) - 1);
  for (int i = 0; i < corners; ++i) {
    bottom.push_back(corners - 1 - i);
    top.push_back(last + i);
  }
  surface.faces = {bottom, top};
  for (int start = 0; start < last; start += corners)
    for (int i = 0; i < corners; ++i) {
      const int next = (i + 1) % corners;
      surface.faces.push_back({start + i, start + next, start + corners + next, start + corners + i});
    }
  return surface;
}

SolidSurface sphere_surface(double radius) {
  constexpr int belts = 18;
  std::vector<Ring> rings;
  for (int i = 0; i <= belts; ++i) {
    const double angle = foundation::two_pi / 2 * i / belts;
    rings.push_back({-radius * std::cos(angle), radius * std::sin(angle)});
  }
  return turned_surface(rings);
}

void add_triangles(const solids::TriangleSurface& triangles, double length_unit, SolidSurface& surface) {
  const int first = static_cast<int>(surface.vertices.size());
  for (Eigen::Index v = 0; v < triangles.vertices.cols(); ++v)
    surface.vertices.emplace_back(triangles.vertices.col(v) * length_unit);
  for (Eigen::Index t = 0; t < triangles.triangles.cols(); ++t) {
    const auto corners = triangles.triangles.col(t);
    surface.faces.push_back({first + corners(0), first + corners(1), first + corners(2)});
  }
}

std::optional<SolidSurface> file_surface(const solids::StlSolid& stl) {
  const auto read = solids::read_stl(stl.file);
  if (!read) return std::nullopt;
  SolidSurface surface;
  add_triangles(solids::welded_surface(*read), stl.length_unit, surface);
  return surface;
}

std::optional<SolidSurface> file_surface(const solids::StepSolid& step) {
  const auto all = solids::step_surfaces(step.file);
  if (!all) return std::nullopt;
  SolidSurface surface;
  for (std::size_t number = 1; number <= all->size(); ++number)
    if (step.solids.empty() || std::ranges::find(step.solids, static_cast<int>(number)) != step.solids.end())
      add_triangles((*all)[number - 1], 1, surface);
  return surface;
}

struct SurfaceOf {
  std::optional<SolidSurface> operator()(const solids::Box& b) const {
    return box_surface(Eigen::Vector3d(b.length_x, b.length_y, b.length_z) / 2);
  }
  std::optional<SolidSurface> operator()(const solids::Cylinder& c) const {
    return turned_surface({{-c.length / 2, c.diameter / 2}, {c.length / 2, c.diameter / 2}});
  }
  std::optional<SolidSurface> operator()(const solids::Tube& t) const {  // outside, and back through the hole
    const double outer = t.outer_diameter / 2, inner = t.inner_diameter / 2, end = t.length / 2;
    SolidSurface surface = turned_surface({{-end, inner}, {-end, outer}, {end, outer}, {end, inner}, {-end, inner}});
    surface.faces.erase(surface.faces.begin(), surface.faces.begin() + 2);  // the hole is open
    const int first = 4 * static_cast<int>(surface.vertices.size()) / 5;    // the last ring is the first one
    for (auto& face : surface.faces)
      for (int& vertex : face) vertex -= vertex >= first ? first : 0;
    surface.vertices.resize(static_cast<std::size_t>(first));
    return surface;
  }
  std::optional<SolidSurface> operator()(const solids::Sphere& s) const { return sphere_surface(s.diameter / 2); }
  std::optional<SolidSurface> operator()(const solids::Cone& c) const {
    return turned_surface({{-c.length / 2, c.start_diameter / 2}, {c.length / 2, c.end_diameter / 2}});
  }
  std::optional<SolidSurface> operator()(const solids::StlSolid& stl) const { return file_surface(stl); }
  std::optional<SolidSurface> operator()(const solids::StepSolid& step) const { return file_surface(step); }
};

}  // namespace

SolidSurface box_surface(const Eigen::Vector3d& half) {
  SolidSurface surface;
  for (int corner = 0; corner < 8; ++corner)
    surface.vertices.emplace_back(half.x() * (corner & 1 ? 1 : -1), half.y() * (corner & 2 ? 1 : -1),
                                  half.z() * (corner & 4 ? 1 : -1));
  surface.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return surface;
}

std::optional<SolidSurface> surface_of(const solids::Part& part) {
  std::optional<SolidSurface> surface = std::visit(SurfaceOf(), part.shape);
  if (surface)
    for (Eigen::Vector3d& v : surface->vertices) v = part.pose.position + part.pose.rotation * v;
  return surface;
}

SolidSurface EquivalentBox::surface() const {
  SolidSurface surface = box_surface(half);
  for (Eigen::Vector3d& v : surface.vertices) v = centre + axes * v;
  return surface;
}

EquivalentBox equivalent_box(const spatial::MassProperties& mass) {
  const spatial::PrincipalInertia inertia = spatial::principal_inertia(mass);
  const Eigen::Vector3d second = Eigen::Vector3d::Constant(inertia.moments.sum()) - 2 * inertia.moments;
  EquivalentBox box{mass.centre, inertia.axes, (1.5 * second.cwiseMax(0) / mass.mass).cwiseSqrt()};
  if (box.axes.col(0).cross(box.axes.col(1)).dot(box.axes.col(2)) < 0)
    box.axes.col(2) *= -1;  // a reflected box would be inside out
  return box;
}

namespace {

SolidSurface on_lattice(const SolidSurface& triangles, const Bounds& bounds, double cell) {
  SolidSurface result;
  std::map<std::array<int, 3>, int> cells;
  std::vector<int> place;
  std::vector<int> count;
  for (const Eigen::Vector3d& v : triangles.vertices) {
    const Eigen::Vector3d at = (v - bounds.low) / cell;
    const auto [found, is_new] =
        cells.try_emplace({static_cast<int>(at.x()), static_cast<int>(at.y()), static_cast<int>(at.z())},
                          static_cast<int>(result.vertices.size()));
    if (is_new) {
      result.vertices.emplace_back(Eigen::Vector3d::Zero());
      count.push_back(0);
    }
    place.push_back(found->second);
    const auto there = static_cast<std::size_t>(found->second);
    result.vertices[there] += v;
    ++count[there];
  }
  for (std::size_t v = 0; v < count.size(); ++v) result.vertices[v] /= count[v];
  for (const std::vector<int>& face : triangles.faces) {
    std::vector<int> moved;
    for (const int v : face) moved.push_back(place[static_cast<std::size_t>(v)]);
    if (moved[0] != moved[1] && moved[1] != moved[2] && moved[2] != moved[0]) result.faces.push_back(std::move(moved));
  }
  return result;
}

}  // namespace

SolidSurface coarsened(const SolidSurface& triangles, std::size_t most) {
  Bounds bounds;
  for (const Eigen::Vector3d& v : triangles.vertices) bounds.include(v);
  SolidSurface result = triangles;
  constexpr double finest = 1.0 / 256, coarser = 1.25;  // cells of the diagonal
  for (double cell = finest * bounds.size(); result.faces.size() > most; cell *= coarser)
    result = on_lattice(triangles, bounds, cell);
  return result;
}

}  // namespace trivet::results
