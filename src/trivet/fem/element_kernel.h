// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/fem/material.h"
#include "trivet/fem/mesh.h"
#include "trivet/fem/tet_pressure.h"

namespace trivet::fem {

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
