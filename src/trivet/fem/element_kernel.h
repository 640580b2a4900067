// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>

#include "trivet/fem/material.h"
#include "trivet/fem/mesh.h"

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

/// Internal forces and their derivative for one element. Unknowns: u_x of all nodes, u_y, u_z, then the pressures of
/// the four corners if they are unknowns of the mesh. Forces in N, pressures in Pa.
struct ElementSystem {
  Eigen::MatrixXd tangent;
  Eigen::VectorXd force;
  bool inverted = false;  ///< the Jacobian determinant of the element or of its deformation is ≤ 0 somewhere
};

/// @param displacement, pressure  of the element's nodes and corners; nullptr means the undeformed element
[[nodiscard]] ElementSystem element_system(Mesh::Kind kind, TetPressure tet_pressure, const Eigen::Matrix3Xd& nodes,
                                           const Material& material, const Eigen::Matrix3Xd* displacement,
                                           const Eigen::Vector4d* pressure);

/// Volume [m³] and the smallest Jacobian determinant over the integration points of an element.
struct ElementVolume {
  double volume = 0, smallest_determinant = 0;
};
[[nodiscard]] ElementVolume element_volume(Mesh::Kind kind, const Eigen::Matrix3Xd& nodes);

}  // namespace trivet::fem
