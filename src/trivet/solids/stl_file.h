// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <filesystem>

#include "trivet/foundation/interruption.h"
#include "trivet/foundation/problems.h"

namespace trivet::solids {

/// Triangles of a surface, in the units of their file. Vertices with equal coordinates are one vertex, numbered in
/// order of first occurrence.
struct TriangleSurface {
  Eigen::Matrix3Xd vertices;
  Eigen::Matrix3Xi triangles;      ///< three vertex numbers from 0, counterclockwise seen from outside
  double printed_step = 0;         ///< of the last digit, if all coordinates are printed with equally many decimals
  foundation::Problems remarks{};  ///< warnings about the file
};

/// Reads an STL file, binary or text. Bytes after the last triangle of a binary file are ignored with a remark. Normals
/// in the file are not used: the order of the vertices determines the outside. Problems have the subject "file".
[[nodiscard]] foundation::Expected<TriangleSurface> read_stl(const std::filesystem::path& file,
                                                             const foundation::Progress& progress = {});

}  // namespace trivet::solids
