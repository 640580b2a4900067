// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/solids/welded_surface.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <vector>

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

namespace {

constexpr double of_largest_coordinate = 2e-5, of_size = 1e-4, of_single_precision = 2.4e-7;
/// Steps of fixed decimals by which two roundings differ in three directions, and the coarsest in terms of the size.
constexpr double printed_steps = 2, coarsest_of_size = 1e-3;
/// Pairs per vertex within the tolerance; beyond it the surface itself is as fine as the tolerance.
constexpr std::size_t most_pairs = 30;

struct Pair {
  int first, second;
  double distance;
};

/// The vertices of a triangle, the lowest first: equal for triangles with the same vertices and the same outside.
std::array<int, 3> from_lowest(const Eigen::Vector3i& triangle) {
  std::array<int, 3> order = {triangle(0), triangle(1), triangle(2)};
  std::rotate(order.begin(), std::ranges::min_element(order), order.end());
  return order;
}

std::string words_of(const Eigen::Vector3d& p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z()); }

/// Drops triangles that repeat an earlier one.
void drop_repeated(TriangleSurface& surface) {
  std::vector<std::pair<std::array<int, 3>, Eigen::Index>> all;
  all.reserve(to_size(surface.triangles.cols()));
  for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t)
    all.emplace_back(from_lowest(surface.triangles.col(t)), t);
  std::ranges::sort(all);
  std::vector<bool> repeats(all.size(), false);
  std::size_t count = 0;
  Eigen::Index first = surface.triangles.cols();
  for (std::size_t i = 1; i < all.size(); ++i) {
    const std::array<int, 3>& corners = all[i].first;
    if (corners != all[i - 1].first || corners[0] == corners[1] || corners[1] == corners[2]) continue;
    repeats[all[i].second] = true;
    first = std::min(first, all[i].second);
    ++count;
  }
  if (count == 0) return;
  surface.remarks.warning("file",
                          fmt::format("{} {} twice, the first at {} in the file's units", count,
                                      count == 1 ? "triangle is written" : "triangles are written",
                                      words_of(surface.vertices.col(surface.triangles(0, first)))),
                          "each triangle of a surface is written once", "the repeated ones are ignored");
  Eigen::Index next = 0;
  for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t)
    if (!repeats[t]) surface.triangles.col(next++) = surface.triangles.col(t).eval();
  surface.triangles.conservativeResize(Eigen::NoChange, next);
}

std::vector<int> open_vertices(const std::vector<SurfaceEdge>& edges) {
  std::vector<int> open;
  for (const SurfaceEdge& edge : edges)
    if (edge.up != edge.down) open.insert(open.end(), {edge.low, edge.high});
  std::ranges::sort(open);
  open.erase(std::ranges::unique(open).begin(), open.end());
  return open;
}

/// Pairs of vertices closer than a tolerance, by a grid of cells of this size; none if there are too many.
std::optional<std::vector<Pair>> near_pairs(const Eigen::Matrix3Xd& vertices, const std::vector<int>& open,
                                            double tolerance) {
  using Cell = std::array<std::int64_t, 3>;
  const auto hash = [](const Cell& cell) {
    std::size_t value = 0;
    for (const std::int64_t part : cell) value = (value ^ static_cast<std::size_t>(part)) * 0x9E3779B97F4A7C15u;
    return value ^ (value >> 29);
  };
  std::unordered_map<Cell, std::vector<int>, decltype(hash)> grid(open.size(), hash);
  std::vector<Pair> pairs;
  for (const int v : open) {
    const Eigen::Vector3d at = vertices.col(v);
    Cell own;
    for (int j = 0; j < 3; ++j) own[j] = static_cast<std::int64_t>(std::floor(at(j) / tolerance));
    for (int near = 0; near < 27; ++near) {
      const auto found = grid.find({own[0] + near % 3 - 1, own[1] + near / 3 % 3 - 1, own[2] + near / 9 - 1});
      if (found == grid.end()) continue;
      for (const int other : found->second)
        if (const double distance = (at - vertices.col(other)).norm(); distance <= tolerance)
          pairs.push_back({other, v, distance});
      if (pairs.size() > most_pairs * open.size()) return std::nullopt;
    }
    grid[own].push_back(v);
  }
  std::ranges::stable_sort(pairs, {}, &Pair::distance);
  return pairs;
}

/// Joins near vertices to clusters, none of which is wider than the tolerance.
class Weld {
 public:
  Weld(const TriangleSurface& surface, const std::vector<SurfaceEdge>& edges, double tolerance, double shortest_edge)
      : vertices_(surface.vertices), edges_(edges), tolerance_(tolerance), shortest_edge_(shortest_edge) {}

  void join(const Pair& pair) {
    const int a = representative(pair.first), b = representative(pair.second);
    if (a == b) return;
    const std::vector<int> one = members(a), other = members(b);
    for (const int i : one)
      for (const int j : other) {
        const double distance = (vertices_.col(i) - vertices_.col(j)).norm();
        if (distance > tolerance_ || (distance > shortest_edge_ && are_joined(i, j))) return;
        widest_ = std::max(widest_, distance);
      }
    std::vector<int>& all = clusters_[std::min(a, b)];
    all = one;
    all.insert(all.end(), other.begin(), other.end());
    clusters_.erase(std::max(a, b));
    for (const int i : all) representative_[i] = std::min(a, b);
    ++count_;
    if (count_ == 1) first_ = pair.first;
  }
  [[nodiscard]] int representative(int vertex) const {
    const auto found = representative_.find(vertex);
    return found == representative_.end() ? vertex : found->second;
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] double widest() const { return widest_; }
  [[nodiscard]] int first() const { return first_; }

 private:
  [[nodiscard]] std::vector<int> members(int vertex) const {
    const auto found = clusters_.find(vertex);
    return found == clusters_.end() ? std::vector<int>{vertex} : found->second;
  }
  [[nodiscard]] bool are_joined(int i, int j) const {
    const std::pair wanted(std::min(i, j), std::max(i, j));
    const auto at = std::lower_bound(edges_.begin(), edges_.end(), wanted,
                                     [](const SurfaceEdge& e, const auto& w) { return std::pair(e.low, e.high) < w; });
    return at != edges_.end() && std::pair(at->low, at->high) == wanted;
  }

  const Eigen::Matrix3Xd& vertices_;
  const std::vector<SurfaceEdge>& edges_;
  const double tolerance_, shortest_edge_;
  std::map<int, std::vector<int>> clusters_;
  std::map<int, int> representative_;
  std::size_t count_ = 0;
  double widest_ = 0;
  int first_ = 0;
};

void weld(TriangleSurface& surface) {
  const std::vector<SurfaceEdge> edges = surface_edges(surface.triangles);
  const std::vector<int> open = open_vertices(edges);
  if (open.empty()) return;
  const Eigen::AlignedBox3d box(surface.vertices.rowwise().minCoeff(), surface.vertices.rowwise().maxCoeff());
  const double largest = surface.vertices.cwiseAbs().maxCoeff(), size = box.diagonal().norm();
  const double tolerance = std::max(std::min(of_largest_coordinate * largest, of_size * size),
                                    std::min(printed_steps * surface.printed_step, coarsest_of_size * size));
  if (!(tolerance > 0)) return;
  const auto pairs = near_pairs(surface.vertices, open, tolerance);
  if (!pairs) return;
  Weld weld(surface, edges, tolerance, std::min(of_single_precision * largest, tolerance));
  for (const Pair& pair : *pairs) weld.join(pair);
  if (weld.count() == 0) return;
  surface.remarks.warning(
      "file",
      fmt::format("{} {} by rounding from another, by up to {:.2g}, the first at {} in the file's units", weld.count(),
                  weld.count() == 1 ? "vertex differs" : "vertices differ", weld.widest(),
                  words_of(surface.vertices.col(weld.first()))),
      fmt::format("vertices of neighbouring triangles are equal; the printed digits explain up to {:.2g}", tolerance),
      "they are read as one; no action is needed if the part has no detail so small");
  for (int& vertex : surface.triangles.reshaped()) vertex = weld.representative(vertex);
}

}  // namespace

TriangleSurface welded_surface(TriangleSurface surface) {
  drop_repeated(surface);
  weld(surface);
  drop_repeated(surface);
  return surface;
}

}  // namespace trivet::solids
