// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace trivet::fem {

/// Second-order mesh of a solid between two rigid plates or sleeves N and K.
struct Mesh {
  enum class Kind { hex27, tet10 };
  Kind kind = Kind::hex27;
  Eigen::Matrix3Xd nodes;             ///< [m]
  Eigen::MatrixXi elements;           ///< 27 or 10 × count, node indices from 0, in gmsh's node order
  std::vector<int> material;          ///< per element: index into the list of materials
  std::vector<int> plate_n, plate_k;  ///< nodes bonded to the rigid plate or sleeve N / K
};

}  // namespace trivet::fem
