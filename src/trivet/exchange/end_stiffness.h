// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

#include "trivet/exchange/named_matrix.h"

namespace trivet::exchange {

/// Rows whose diagonal entry is no stiffness but stands for a component that a boundary condition fixes: Abaqus writes
/// 1e36 there, other programs other large numbers. It is 10¹² times larger than every other entry of its row, which no
/// stress-free element allows (its diagonal balances the others through arms), or ≥ 10³⁰.
[[nodiscard]] std::vector<int> fixed_components(const Eigen::MatrixXd& matrix);

/// Replaces the diagonal entries of these rows by those with which each rigid motion needs no force: with the columns
/// of `motions` turned into unit motions of the end of row i, K_ii = −Σ_{j≠i} K_ij T_j.
/// @param motions  six independent rigid motions of both ends, 12 × 6
[[nodiscard]] Eigen::Matrix<double, 12, 12> completed_by_rigid_motion(const Eigen::Matrix<double, 12, 12>& matrix,
                                                                      const std::vector<int>& rows,
                                                                      const Eigen::Matrix<double, 12, 6>& motions);

using Matrix12 = Eigen::Matrix<double, 12, 12>;

/// Matrix of the two ends of an element, order (u_N, θ_N, u_K, θ_K), in the axes and units of its file.
struct EndMatrix {
  Matrix12 values = Matrix12::Zero();
  std::optional<Matrix12> imaginary;  ///< if the file is complex
  foundation::Problems warnings;
};

/// An end that is one node: components 1–3 are its translations, 4–6 its rotations. In CalculiX a rigid body has a
/// second node with the rotations as components 1–3: the `rotation_node`.
struct NodeEnd {
  int node = 0;
  int rotation_node = 0;  ///< 0: the node itself
};

/// An end that is a rigid plate: its nodes are rigidly attached to the point. In the length unit of the file.
struct RigidEnd {
  struct At {
    int node = 0;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
  };
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  std::vector<At> nodes;
};

/// Static condensation onto two nodes: K_bb − K_bi K_ii⁻¹ K_ib, exact in statics. Rows and columns of zeros are ignored
/// with a warning; a singular interior is an error that names a component that moves freely.
[[nodiscard]] foundation::Expected<EndMatrix> reduce_to_ends(const NamedMatrix& matrix, const NodeEnd& n,
                                                             const NodeEnd& k);

/// The same onto two rigid plates.
[[nodiscard]] foundation::Expected<EndMatrix> reduce_to_ends(const NamedMatrix& matrix, const RigidEnd& n,
                                                             const RigidEnd& k);

/// The same onto twelve rows, counted from 1, for files without labels.
[[nodiscard]] foundation::Expected<EndMatrix> reduce_to_rows(const NamedMatrix& matrix,
                                                             const std::array<int, 12>& rows);

/// Converts a stiffness from the units of a file (length unit [m], force unit [N], angles in rad) to N/m, N/rad, N m/m,
/// N m/rad. A file in mm, N, tonne has 0.001 and 1.
/// @throws InvalidInput unless both units are finite and > 0
[[nodiscard]] Matrix12 in_si(const Matrix12& matrix, double length_unit, double force_unit);

}  // namespace trivet::exchange
