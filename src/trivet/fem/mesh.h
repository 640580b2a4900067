// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

#include "trivet/fem/material.h"
#include "trivet/foundation/problems.h"

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

/// All reasons why a mesh cannot be condensed: wrong node numbers, non-finite coordinates, plates without nodes or with
/// common nodes, elements without material, inverted elements, no volume, pieces on no plate, no piece that connects
/// the plates, invalid materials. An error gives one example by number (from 0) and position.
[[nodiscard]] foundation::Problems check_mesh(const Mesh& mesh, const std::vector<Material>& materials);

/// @throws InvalidInput with the first error of `check_mesh`
void require_sound(const Mesh& mesh, const std::vector<Material>& materials);

}  // namespace trivet::fem
