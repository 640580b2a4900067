// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <utility>

#include "trivet/fem/mesh.h"

namespace trivet::test {

/// Each hexahedron as six tetrahedra about its diagonal, on the same nodes; in a regular grid neighbours match.
inline fem::Mesh in_tetrahedra(const fem::Mesh& hexahedra) {
  constexpr int gmsh_lattice[27][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2},
                                       {0, 2, 2}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 1, 0}, {2, 0, 1}, {1, 2, 0},
                                       {2, 2, 1}, {0, 2, 1}, {1, 0, 2}, {0, 1, 2}, {2, 1, 2}, {1, 2, 2}, {1, 1, 0},
                                       {1, 0, 1}, {0, 1, 1}, {2, 1, 1}, {1, 2, 1}, {1, 1, 2}, {1, 1, 1}};
  int number[27];
  for (int a = 0; a < 27; ++a) number[gmsh_lattice[a][0] + 3 * gmsh_lattice[a][1] + 9 * gmsh_lattice[a][2]] = a;
  constexpr int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};  // even, then odd permutations
  constexpr int edges[6][2] = {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}};
  fem::Mesh mesh = hexahedra;
  mesh.kind = fem::Mesh::Kind::tet10;
  mesh.material.clear();
  mesh.elements.resize(10, 6 * hexahedra.elements.cols());
  for (Eigen::Index t = 0; t < mesh.elements.cols(); ++t) {
    Eigen::Vector3i corner[4] = {Eigen::Vector3i::Zero(), {}, {}, Eigen::Vector3i::Constant(2)};
    corner[1] = 2 * Eigen::Vector3i::Unit(orders[t % 6][0]);
    corner[2] = corner[1] + 2 * Eigen::Vector3i::Unit(orders[t % 6][1]);
    if (t % 6 >= 3) std::swap(corner[1], corner[2]);
    const auto node = [&](const Eigen::Vector3i& p) {
      return hexahedra.elements(number[p.x() + 3 * p.y() + 9 * p.z()], t / 6);
    };
    for (int c = 0; c < 4; ++c) mesh.elements(c, t) = node(corner[c]);
    for (int e = 0; e < 6; ++e) mesh.elements(4 + e, t) = node((corner[edges[e][0]] + corner[edges[e][1]]) / 2);
    mesh.material.push_back(hexahedra.material[t / 6]);
  }
  return mesh;
}

}  // namespace trivet::test
