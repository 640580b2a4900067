// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace trivet::test {

/// Triangles by their corners, for writing STL.
using Triangle = std::array<Eigen::Vector3d, 3>;
using Triangles = std::vector<Triangle>;

/// Triangles of the points `at(i, j)`, a grid closed in both directions: two triangles per cell, counterclockwise for
/// i → right, j → up.
template <typename Point>
Triangles grid_surface(int columns, int rows, const Point& at) {
  Triangles triangles;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return triangles;
}

/// The twelve triangles of a box between two corners, facing outwards.
Triangles box_triangles(const Eigen::Vector3d& low, const Eigen::Vector3d& high);
/// The same triangles facing the other way.
Triangles turned(Triangles triangles);
Triangles together(Triangles first, const Triangles& second);

std::string stl_text(const Triangles& triangles);
std::string stl_binary(const Triangles& triangles);
void write_file(const std::filesystem::path& file, const std::string& bytes);

}  // namespace trivet::test
