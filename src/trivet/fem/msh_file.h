// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "trivet/foundation/problems.h"

namespace trivet::fem {

/// Second-order triangles and tetrahedra of a text file in gmsh's format 2.2, with gmsh's numbers of the faces and
/// solids that they mesh. Nodes are numbered from 0 in file order; unused nodes are kept. Other element types are
/// skipped.
struct MshFile {
  Eigen::Matrix3Xd nodes;      ///< in the file's unit
  Eigen::MatrixXi triangles;   ///< 6 × count
  std::vector<int> face;       ///< of each triangle
  Eigen::MatrixXi tetrahedra;  ///< 10 × count
  std::vector<int> solid;      ///< of each tetrahedron
};

/// A problem's subject is "mesh".
[[nodiscard]] foundation::Expected<MshFile> read_msh(const std::filesystem::path& file);

}  // namespace trivet::fem
