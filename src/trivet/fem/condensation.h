// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/fem/material.h"
#include "trivet/fem/mesh.h"
#include "trivet/foundation/interruption.h"
#include "trivet/spatial/types.h"

namespace trivet::fem {

/// Where the element has its ends, in the coordinates of the mesh: reference points of plates N and K [m] and the axes
/// of the element as columns.
struct ElementFrame {
  Eigen::Vector3d point_n = Eigen::Vector3d::Zero(), point_k = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

struct CondensationOptions {
  int threads = 0;            ///< 0: as many as the machine has
  double memory_limit = 4e9;  ///< [byte]; a larger solid is refused before anything is computed
};

/// Static stiffness of a stress-free solid between its plates.
struct SolidStiffness {
  spatial::Matrix12 stiffness =
      spatial::Matrix12::Zero();  ///< (u_N, θ_N, u_K, θ_K) in the element's axes; stores nothing in a rigid motion
  /// Estimated error of the discretisation per entry, |ΔC_ij| / √(C_ii C_jj); zero where no second computation was
  /// made.
  spatial::Matrix12 relative_error = spatial::Matrix12::Zero();
  double rigid_residual =
      0;  ///< largest entry of (C computed from all 12 motions − C from 6 and equilibrium), scaled alike: round-off
  int unknowns = 0, elements = 0;
};

/// Stiffness of one mesh as it is: hexahedra with a condensed linear pressure; of tetrahedra the mean of the two kinds
/// of pressure that bracket the answer, with half their difference as the estimated error.
/// @throws InvalidInput with the first finding if `check_mesh` has one, or if the solid needs more memory than the
/// limit
/// @throws NotComputable if a part of the solid is not held; Interrupted from `progress`
[[nodiscard]] SolidStiffness condense(const Mesh& mesh, const std::vector<Material>& materials,
                                      const ElementFrame& frame, const CondensationOptions& options = {},
                                      const foundation::Progress& progress = {});

/// Stiffness on the finer of two meshes of the same solid. `refinement` > 1 is the ratio of their element sizes: an
/// error that falls in proportion to the size, as at worst at the singular bonded edges, is 1/(refinement − 1) times
/// the difference; that is the estimate.
[[nodiscard]] SolidStiffness condense(const Mesh& fine, const Mesh& coarse, double refinement,
                                      const std::vector<Material>& materials, const ElementFrame& frame,
                                      const CondensationOptions& options = {},
                                      const foundation::Progress& progress = {});

}  // namespace trivet::fem
