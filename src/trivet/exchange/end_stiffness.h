// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "trivet/exchange/named_matrix.h"

namespace trivet::exchange {

using Matrix12 = Eigen::Matrix<double, 12, 12>;

/// A matrix on the two ends of an element, order (u_N, θ_N, u_K, θ_K), in the axes and units of its file.
struct EndMatrix {
  Matrix12 values = Matrix12::Zero();
  std::optional<Matrix12> imaginary;  ///< of a complex file
  foundation::Problems warnings;
};

/// An end that is one node: components 1–3 are its translations, 4–6 its rotations. CalculiX gives a rigid body a
/// second node whose components 1–3 are the rotations: name it as `rotation_node`.
struct NodeEnd {
  int node = 0;
  int rotation_node = 0;  ///< 0: the node itself
};

/// An end that is a rigid plate: all components of the nodes move with the point. In the length unit of the file.
struct RigidEnd {
  struct At {
    int node = 0;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
  };
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  std::vector<At> nodes;
};

/// Static condensation onto two nodes: K_bb − K_bi K_ii⁻¹ K_ib, exact in statics. Rows and columns that are zero
/// altogether are left out with a warning; a singular interior is a problem that names a component which moves freely.
[[nodiscard]] foundation::Expected<EndMatrix> reduce_to_ends(const NamedMatrix& matrix, const NodeEnd& n,
                                                             const NodeEnd& k);

/// The same onto two rigid plates.
[[nodiscard]] foundation::Expected<EndMatrix> reduce_to_ends(const NamedMatrix& matrix, const RigidEnd& n,
                                                             const RigidEnd& k);

/// The same onto twelve rows, counted from 1, for files without labels.
[[nodiscard]] foundation::Expected<EndMatrix> reduce_to_rows(const NamedMatrix& matrix,
                                                             const std::array<int, 12>& rows);

/// A stiffness in N/m, N/rad, N m/m, N m/rad from one in the units of a file: its length unit [m], its force unit [N],
/// its angles in rad. A file in mm, N, tonne has 0.001 and 1.
/// @throws InvalidInput unless both units are finite and > 0
[[nodiscard]] Matrix12 in_si(const Matrix12& matrix, double length_unit, double force_unit);

}  // namespace trivet::exchange
