// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/fem/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "trivet/fem/element_kernel.h"
#include "trivet/foundation/first_error.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::fem {

namespace {

using foundation::Problems;

std::string place(const Eigen::Vector3d& x) { return fmt::format("({:.4g}, {:.4g}, {:.4g}) m", x.x(), x.y(), x.z()); }

bool check_shape(const Mesh& mesh, Problems& problems) {
  const Eigen::Index expected = mesh.kind == Mesh::Kind::hex27 ? 27 : 10;
  if (mesh.elements.cols() == 0 || mesh.nodes.cols() == 0) {
    problems.error("mesh", "no elements", "a solid needs elements", "check that the shape or file contains a solid");
    return false;
  }
  if (mesh.elements.rows() != expected) {
    problems.error("mesh", fmt::format("{} nodes per element", mesh.elements.rows()),
                   fmt::format("this element type has {}", expected), "mesh with second-order elements");
    return false;
  }
  const auto outside = [&](int node) { return node < 0 || node >= mesh.nodes.cols(); };
  const bool wrong_node = std::any_of(mesh.elements.data(), mesh.elements.data() + mesh.elements.size(), outside) ||
      std::ranges::any_of(mesh.plate_n, outside) || std::ranges::any_of(mesh.plate_k, outside);
  if (wrong_node)
    problems.error("mesh", "a node number that does not exist",
                   fmt::format("node numbers are 0 … {}", mesh.nodes.cols() - 1), "check the mesh file");
  if (!mesh.nodes.allFinite())
    problems.error("mesh", "a coordinate is not a finite number", "coordinates must be finite, in m",
                   "check the mesh file");
  return !problems.has_errors();
}

void check_materials(const Mesh& mesh, const std::vector<Material>& materials, Problems& problems) {
  if (to_index(mesh.material.size()) != mesh.elements.cols())
    problems.error("material",
                   fmt::format("{} material numbers for {} elements", mesh.material.size(), mesh.elements.cols()),
                   "every element has one material", "give each solid of the file a material");
  for (std::size_t e = 0; e < mesh.material.size(); ++e)
    if (mesh.material[e] < 0 || to_size(mesh.material[e]) >= materials.size()) {
      problems.error("material", fmt::format("element {} has material {}", e, mesh.material[e]),
                     fmt::format("{} materials are given", materials.size()), "give each solid of the file a material");
      break;
    }
  for (std::size_t m = 0; m < materials.size(); ++m) {
    Problems found = check(materials[m]);
    for (foundation::Problem& problem : found.list())
      problem.subject = fmt::format("materials[{}].{}", m, problem.subject);
    problems.add(found);
  }
}

void check_plates(const Mesh& mesh, Problems& problems) {
  if (mesh.plate_n.empty())
    problems.error("plate_n", "no nodes", "plate N must be bonded to a face of the solid",
                   "check which face is selected, and its position");
  if (mesh.plate_k.empty())
    problems.error("plate_k", "no nodes", "plate K must be bonded to a face of the solid",
                   "check which face is selected, and its position");
  std::vector<char> on_n(to_size(mesh.nodes.cols()), 0);
  for (const int node : mesh.plate_n) on_n[node] = 1;
  int shared = 0, example = 0;
  for (const int node : mesh.plate_k)
    if (on_n[node]) {
      ++shared;
      example = node;
    }
  if (shared > 0)
    problems.error("plate_k",
                   fmt::format("{} nodes also belong to plate N, one at {}", shared, place(mesh.nodes.col(example))),
                   "the plates must have no common point", "select faces that do not touch");
}

void check_elements(const Mesh& mesh, Problems& problems) {
  int inverted = 0;
  Eigen::Index example = 0;
  double volume = 0;
  Eigen::Matrix3Xd x(3, mesh.elements.rows());
  for (Eigen::Index e = 0; e < mesh.elements.cols(); ++e) {
    for (Eigen::Index a = 0; a < x.cols(); ++a) x.col(a) = mesh.nodes.col(mesh.elements(a, e));
    const ElementVolume v = element_volume(mesh.kind, x);
    volume += v.volume;
    if (!(v.smallest_determinant > 0)) {
      ++inverted;
      example = e;
    }
  }
  if (inverted == 0) return;
  if (!(volume > 0)) {
    problems.error("mesh", fmt::format("a volume of {:.3g} m³", volume), "a solid must have a volume > 0",
                   "check the dimensions and the orientation of the elements");
    return;
  }
  problems.error("mesh",
                 fmt::format("{} of {} elements are flat or inverted, e.g. element {} at {}", inverted,
                             mesh.elements.cols(), example, place(mesh.nodes.col(mesh.elements(0, example)))),
                 "the Jacobian determinant of every element must be positive",
                 "refine the mesh at curved surfaces, or remove slivers from the shape");
}

/// Connected pieces of the solid: for each node the smallest node number of its piece.
std::vector<int> pieces(const Mesh& mesh) {
  std::vector<int> parent(to_size(mesh.nodes.cols()));
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int node) {
    while (parent[node] != node) node = parent[node] = parent[parent[node]];
    return node;
  };
  for (Eigen::Index e = 0; e < mesh.elements.cols(); ++e)
    for (Eigen::Index a = 1; a < mesh.elements.rows(); ++a) {
      const int one = root(mesh.elements(0, e)), other = root(mesh.elements(a, e));
      parent[std::max(one, other)] = std::min(one, other);
    }
  for (int node = 0; node < mesh.nodes.cols(); ++node) parent[node] = root(node);
  return parent;
}

void check_pieces(const Mesh& mesh, Problems& problems) {
  const std::vector<int> piece = pieces(mesh);
  std::vector<char> bonds(piece.size(), 0), used(piece.size(), 0);
  for (const int node : mesh.plate_n) bonds[piece[node]] |= 1;
  for (const int node : mesh.plate_k) bonds[piece[node]] |= 2;
  for (const int node : mesh.elements.reshaped()) used[node] = 1;
  bool joined = false;
  for (std::size_t node = 0; node < piece.size(); ++node) {
    if (!used[node]) {
      problems.error("mesh",
                     fmt::format("node {} at {} belongs to no element", node, place(mesh.nodes.col(to_index(node)))),
                     "every node must belong to an element", "remove points that only serve the drawing");
      return;
    }
    if (piece[node] != static_cast<int>(node)) continue;
    joined = joined || bonds[node] == 3;
    if (bonds[node] == 0)
      problems.error(
          "mesh",
          fmt::format("the piece with the point {} is not bonded to a plate", place(mesh.nodes.col(to_index(node)))),
          "every piece of the solid must be bonded to a plate",
          "join the solids of the file, so that they share their faces");
  }
  if (!joined && !mesh.plate_n.empty() && !mesh.plate_k.empty())
    problems.error("mesh", "no piece connects plate N with plate K", "the solid must connect its plates",
                   "join the solids of the file, so that they share their faces");
}

}  // namespace

Problems check_mesh(const Mesh& mesh, const std::vector<Material>& materials) {
  Problems problems;
  if (!check_shape(mesh, problems)) return problems;
  check_materials(mesh, materials, problems);
  check_plates(mesh, problems);
  check_elements(mesh, problems);
  check_pieces(mesh, problems);
  return problems;
}

void require_sound(const Mesh& mesh, const std::vector<Material>& materials) {
  foundation::refuse_errors(check_mesh(mesh, materials));
}

}  // namespace trivet::fem
