// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/solids/closed_surface.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numeric>
#include <set>

#include "trivet/foundation/index.h"
#include "trivet/solids/welded_surface.h"

namespace trivet::solids {

VolumeIntegrals placed(const VolumeIntegrals& v, const spatial::Pose& pose) {
  return {v.volume, pose.position + pose.rotation * v.centre,
          pose.rotation * v.second_moment * pose.rotation.transpose()};
}

VolumeIntegrals sum(const VolumeIntegrals& a, const VolumeIntegrals& b) {
  VolumeIntegrals total;
  total.volume = a.volume + b.volume;
  if (total.volume == 0) return total;
  const Eigen::Vector3d between = b.centre - a.centre;
  total.centre = a.centre + b.volume / total.volume * between;
  total.second_moment =
      a.second_moment + b.second_moment + a.volume * b.volume / total.volume * between * between.transpose();
  return total;
}

spatial::MassProperties mass_properties(const VolumeIntegrals& v, double density) {
  const Eigen::Matrix3d inertia = v.second_moment.trace() * Eigen::Matrix3d::Identity() - v.second_moment;
  return {density * v.volume, v.centre, density * inertia};
}

namespace {

using foundation::Problems;

constexpr double flat = 1e-7;  // binary coordinates: 6e-8 of the extent at best; volume ≤ flat·area·extent counts as 0
constexpr double degenerate = 1e-12;  // area over squared longest edge
constexpr std::size_t most_listed_holes = 5;

/// Sets of connected vertices.
class Connected {
 public:
  explicit Connected(Eigen::Index count) : parent_(to_size(count)) { std::iota(parent_.begin(), parent_.end(), 0); }
  int root(int i) {
    while (parent(i) != i) i = parent(i) = parent(parent(i));
    return i;
  }
  void join(int a, int b) { parent(std::max(root(a), root(b))) = std::min(root(a), root(b)); }

 private:
  int& parent(int i) { return parent_[i]; }
  std::vector<int> parent_;
};

std::string point(const Eigen::Vector3d& p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z()); }

std::string place(const TriangleSurface& surface, const std::vector<SurfaceEdge>& edges) {
  Eigen::AlignedBox3d box;
  for (const SurfaceEdge& edge : edges)
    box.extend(surface.vertices.col(edge.low)).extend(surface.vertices.col(edge.high));
  return fmt::format("around {}, from {} to {}", point(box.center()), point(box.min()), point(box.max()));
}

/// Edges in connected groups, in order of their lowest vertex.
std::vector<std::vector<SurfaceEdge>> groups(const TriangleSurface& surface, const std::vector<SurfaceEdge>& edges) {
  Connected connected(surface.vertices.cols());
  for (const SurfaceEdge& edge : edges) connected.join(edge.low, edge.high);
  std::map<int, std::vector<SurfaceEdge>> by_root;
  for (const SurfaceEdge& edge : edges) by_root[connected.root(edge.low)].push_back(edge);
  std::vector<std::vector<SurfaceEdge>> list;
  for (auto& [root, group] : by_root) list.push_back(std::move(group));
  return list;
}

/// Triangles that are there twice, facing opposite sides, where the surface is not closed: no hole. Their edges are
/// removed from `open`.
void report_opposed(const TriangleSurface& surface, std::vector<SurfaceEdge>& open, Problems& problems) {
  std::set<std::pair<int, int>> open_edges;
  for (const SurfaceEdge& edge : open) open_edges.emplace(edge.low, edge.high);
  std::map<std::array<int, 3>, int> sides;  ///< sum of the signs of the order of the vertices
  std::map<std::array<int, 3>, int> count;
  for (const auto& triangle : surface.triangles.colwise()) {
    std::array<int, 3> corners = {triangle(0), triangle(1), triangle(2)};
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    const int side = corners[1] < corners[2] ? 1 : -1;
    std::ranges::sort(corners);
    if (!open_edges.contains({corners[0], corners[1]}) || !open_edges.contains({corners[1], corners[2]}) ||
        !open_edges.contains({corners[0], corners[2]}))
      continue;
    sides[corners] += side;
    ++count[corners];
  }
  std::vector<SurfaceEdge> of_pairs;
  std::size_t pairs = 0;
  for (const auto& [corners, side] : sides) {
    if (side != 0 || count[corners] < 2) continue;
    ++pairs;
    const auto belongs = [&, c = corners](const SurfaceEdge& edge) {
      return std::ranges::find(c, edge.low) != c.end() && std::ranges::find(c, edge.high) != c.end();
    };
    std::ranges::copy_if(open, std::back_inserter(of_pairs), belongs);
    std::erase_if(open, belongs);
  }
  if (pairs > 0)
    problems.error(
        "file",
        fmt::format("{} there twice, facing opposite sides, {} in the file's units",
                    pairs == 1 ? "one triangle is" : fmt::format("{} triangles are", pairs), place(surface, of_pairs)),
        "each triangle of a closed surface is there once and faces outwards",
        "remove the one that faces inwards in the program that made it, then export it again");
}

void check_edges(const TriangleSurface& surface, Problems& problems) {
  std::vector<SurfaceEdge> open, turned, shared;
  for (const SurfaceEdge& edge : surface_edges(surface.triangles)) {
    if (edge.up == edge.down && edge.up > 1) shared.push_back(edge);
    if (edge.up == edge.down) continue;
    (edge.up + edge.down == 2 ? turned : open).push_back(edge);
  }
  report_opposed(surface, open, problems);
  const auto holes = groups(surface, open);
  for (std::size_t i = 0; i < std::min(holes.size(), most_listed_holes); ++i)
    problems.error("file",
                   fmt::format("hole {} of {}: {} open edges {} in the file's units", i + 1, holes.size(),
                               holes[i].size(), place(surface, holes[i])),
                   "each edge of a closed surface belongs to two triangles",
                   "close the surface in the program that made it, then export it again");
  if (!turned.empty())
    problems.error("file",
                   fmt::format("{} edges between triangles that face opposite sides, {} in the file's units",
                               turned.size(), place(surface, turned)),
                   "all triangles must face outwards",
                   "orient the surface in the program that made it, then export it again");
  if (!shared.empty())
    problems.warning("file",
                     fmt::format("{} edges belong to more than two triangles, {} in the file's units", shared.size(),
                                 place(surface, shared)),
                     "parts that touch along an edge are separate volumes",
                     "no action is needed if parts should touch there");
}

void check_triangles(const TriangleSurface& surface, Problems& problems) {
  Eigen::Index count = 0, first = 0;
  for (Eigen::Index t = surface.triangles.cols() - 1; t >= 0; --t) {
    const Eigen::Vector3d a = surface.vertices.col(surface.triangles(0, t)),
                          b = surface.vertices.col(surface.triangles(1, t)) - a,
                          c = surface.vertices.col(surface.triangles(2, t)) - a;
    const double longest = std::max({b.squaredNorm(), c.squaredNorm(), (b - c).squaredNorm()});
    if (b.cross(c).norm() <= degenerate * longest) ++count, first = t;
  }
  if (count > 0)
    problems.warning("file",
                     fmt::format("{} degenerate triangles, the first at {} in the file's units", count,
                                 point(surface.vertices.col(surface.triangles(0, first)))),
                     "a triangle without area encloses no volume",
                     "no action is needed: they do not change the result");
}

struct Shell {
  VolumeIntegrals integrals;
  double area = 0;
  Eigen::AlignedBox3d box;
};

/// Sums over the tetrahedra from the origin to each triangle; second moment about the origin: det/120 (Σ v vᵀ + s sᵀ),
/// s = Σ v.
struct TetrahedronSums {
  double volume = 0, area = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const double determinant = a.dot(b.cross(c));
    const Eigen::Vector3d s = a + b + c;
    volume += determinant / 6;
    area += (b - a).cross(c - a).norm() / 2;
    first += determinant / 24 * s;
    second += determinant / 120 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
  }
};

std::vector<Shell> shells_of(const TriangleSurface& surface) {
  Connected connected(surface.vertices.cols());
  for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t)
    for (int j = 1; j < 3; ++j) connected.join(surface.triangles(0, t), surface.triangles(j, t));
  std::map<int, Shell> shells;
  std::map<int, TetrahedronSums> sums;
  for (Eigen::Index i = 0; i < surface.vertices.cols(); ++i)
    shells[connected.root(static_cast<int>(i))].box.extend(surface.vertices.col(i));
  for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) {
    const int root = connected.root(surface.triangles(0, t));
    const Eigen::Vector3d middle = shells[root].box.center();
    sums[root].add(surface.vertices.col(surface.triangles(0, t)) - middle,
                   surface.vertices.col(surface.triangles(1, t)) - middle,
                   surface.vertices.col(surface.triangles(2, t)) - middle);
  }
  std::vector<Shell> list;
  for (auto& [root, shell] : shells) {
    const TetrahedronSums& sum = sums[root];
    shell.area = sum.area;
    if (sum.area == 0) continue;  // degenerate triangles only
    shell.integrals.volume = sum.volume;
    if (sum.volume != 0) {
      const Eigen::Vector3d centre = sum.first / sum.volume;
      shell.integrals.centre = shell.box.center() + centre;
      shell.integrals.second_moment = sum.second - sum.volume * centre * centre.transpose();
    }
    list.push_back(shell);
  }
  return list;
}

void check_shells(const std::vector<Shell>& shells, Problems& problems) {
  if (shells.empty())
    problems.error("file", "no triangle has an area", "a solid has a volume > 0", "export the part again as STL");
  for (const Shell& shell : shells) {
    const std::string place =
        fmt::format("from {} to {} in the file's units", point(shell.box.min()), point(shell.box.max()));
    if (std::abs(shell.integrals.volume) <= flat * shell.area * shell.box.diagonal().norm()) {
      problems.error("file",
                     fmt::format("a surface of area {:.6g} {} encloses the volume {:.3g}", shell.area, place,
                                 shell.integrals.volume),
                     "a solid has a volume > 0", "remove the flat part, or give it its thickness");
    } else if (shell.integrals.volume < 0 &&
               std::ranges::none_of(
                   shells,
                   [&](const Shell& outer) {
                     return outer.integrals.volume > -shell.integrals.volume && outer.box.contains(shell.box);
                   })) {
      problems.error("file", fmt::format("the surface {} faces inwards: volume {:.6g}", place, shell.integrals.volume),
                     "a surface faces outwards; only a cavity inside another surface faces inwards",
                     "turn the surface over and export it again");
    }
  }
}

}  // namespace

foundation::Expected<EnclosedVolume> enclosed_volume(const TriangleSurface& given) {
  const TriangleSurface surface = welded_surface(given);
  EnclosedVolume enclosed;
  enclosed.remarks = surface.remarks;
  check_edges(surface, enclosed.remarks);
  check_triangles(surface, enclosed.remarks);
  if (enclosed.remarks.has_errors()) return tl::unexpected(enclosed.remarks);
  const std::vector<Shell> shells = shells_of(surface);
  check_shells(shells, enclosed.remarks);
  if (enclosed.remarks.has_errors()) return tl::unexpected(enclosed.remarks);
  enclosed.shells = static_cast<int>(shells.size());
  for (const Shell& shell : shells) {
    enclosed.cavities += shell.integrals.volume < 0;
    enclosed.integrals = sum(enclosed.integrals, shell.integrals);
  }
  return enclosed;
}

}  // namespace trivet::solids
