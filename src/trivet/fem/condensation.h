// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/fem/material.h"
#include "trivet/fem/mesh.h"
#include "trivet/foundation/interruption.h"
#include "trivet/spatial/types.h"

namespace trivet::fem {

/// Ends of the element in the coordinates of the mesh: reference points of plates N and K [m], and the axes of the
/// element as columns.
struct ElementFrame {
  Eigen::Vector3d point_n = Eigen::Vector3d::Zero(), point_k = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

struct CondensationOptions {
  int threads = 0;            ///< 0: as many as the machine has
  double memory_limit = 4e9;  ///< [byte]; a solid that needs more is rejected before the computation
};

/// Static stiffness of a stress-free solid between its plates.
struct SolidStiffness {
  spatial::Matrix12 stiffness =
      spatial::Matrix12::Zero();  ///< (u_N, θ_N, u_K, θ_K) in the element's axes; no strain energy in a rigid motion
  /// Estimated error of the discretisation per entry, |ΔC_ij| / √(C_ii C_jj); zero if there was no second computation.
  spatial::Matrix12 relative_error = spatial::Matrix12::Zero();
  double rigid_residual = 0;  ///< largest entry of (C computed from all 12 motions − C from 6 and equilibrium), with
                              ///< the same scaling: round-off
  int unknowns = 0, elements = 0;
};

/// Stiffness on one mesh: hexahedra with a condensed linear pressure; for tetrahedra the mean of the two pressure
/// formulations that bracket the result, with half their difference as the estimated error.
/// @throws InvalidInput with the first error of `check_mesh`, or if the solid needs more memory than the limit
/// @throws NotComputable if a part of the solid is not held by the plates; Interrupted from `progress`
[[nodiscard]] SolidStiffness condense(const Mesh& mesh, const std::vector<Material>& materials,
                                      const ElementFrame& frame, const CondensationOptions& options = {},
                                      const foundation::Progress& progress = {});

/// Stiffness on the finer of two meshes of the same solid. `refinement` > 1 is the ratio of their element sizes. The
/// estimated error is the difference / (refinement − 1), for an error proportional to the element size: the worst case,
/// at singular bonded edges.
[[nodiscard]] SolidStiffness condense(const Mesh& fine, const Mesh& coarse, double refinement,
                                      const std::vector<Material>& materials, const ElementFrame& frame,
                                      const CondensationOptions& options = {},
                                      const foundation::Progress& progress = {});

}  // namespace trivet::fem
