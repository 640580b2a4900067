// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

namespace trivet::fem {

/// Triquadratic hexahedron on [−1, 1]³ with 3×3×3 Gauss points, gmsh's node order.
struct Hex27 {
  static constexpr int nodes = 27, points = 27;
  static Eigen::Matrix<double, 3, 27> gradients(int point);  ///< ∂N/∂ξ at a point
  static Eigen::Matrix<double, 27, 1> values(int point);
  static double weight(int point);
  /// Place of each node on the 3×3×3 lattice of the element, 0 … 2 per direction.
  static const std::array<std::array<int, 3>, 27>& lattice();
};

/// Quadratic tetrahedron with the four-point rule, gmsh's node order.
struct Tet10 {
  static constexpr int nodes = 10, points = 4;
  static Eigen::Matrix<double, 3, 10> gradients(int point);
  static Eigen::Matrix<double, 10, 1> values(int point);
  static double weight(int point);
  static Eigen::Vector4d barycentric(int point);
  /// The two corners adjacent to each of the six mid-edge nodes 4 … 9.
  static const std::array<std::array<int, 2>, 6>& edges();
};

}  // namespace trivet::fem
