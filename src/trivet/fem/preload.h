// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "trivet/fem/condensation.h"
#include "trivet/fem/material.h"

namespace trivet::fem {

/// A static load of end K relative to a fixed end N, in the axes of the element: per component either a displacement
/// (translation of the reference point [m]; rotations [rad] as one rotation vector, applied in steps) or a load (force
/// [N]; moment [N m] about the moved reference point, in axes that do not turn with the plate).
struct Preload {
  spatial::Vector6 value = spatial::Vector6::Zero();
  std::array<bool, 6> is_load = {false, false, false, false, false, false};
};

struct PreloadOptions {
  int steps = 4;             ///< equal load steps; a step that fails is halved
  int most_iterations = 12;  ///< Newton iterations per load step
  double tolerance = 1e-9;   ///< unbalanced forces / forces on the plates
  TetPressure tet_pressure = TetPressure::continuous;
  CondensationOptions condensation = {};
};

/// Tangent stiffness about the preloaded state.
struct PreloadedStiffness {
  bool converged = false;
  std::string failure_reason;  ///< if not converged: the cause, and the part of the load that was reached; the other
                               ///< members then describe the last state reached
  double reached = 0;          ///< fraction of the load in equilibrium, 1 if converged

  /// (u_N, θ_N, u_K, θ_K) about the moved reference points, in the axes of the element, second-order rotation of the
  /// plates included. K R_trans = 0; a rigid rotation φ gives the rotated preload: φ × force in the force rows, ½ φ ×
  /// moment in the moment rows.
  spatial::Matrix12 stiffness = spatial::Matrix12::Zero();
  spatial::Vector12 preload =
      spatial::Vector12::Zero();  ///< wrench of the plates on the element [N, N m] about the moved reference points
  Eigen::Vector3d arm = Eigen::Vector3d::Zero();       ///< from N to K in the preloaded state [m]
  spatial::Vector6 motion = spatial::Vector6::Zero();  ///< of K: translation [m] and rotation vector [rad]
  int negative_eigenvalues = 0;   ///< of the free part; > 0: the solid has buckled between its plates
  std::vector<double> unbalance;  ///< per Newton iteration, relative; converges quadratically at the end of each step
};

/// @throws InvalidInput as `condense`, and if the load is not finite or has no steps
[[nodiscard]] PreloadedStiffness preloaded_stiffness(const Mesh& mesh, const std::vector<Material>& materials,
                                                     const ElementFrame& frame, const Preload& preload,
                                                     const PreloadOptions& options = {},
                                                     const foundation::Progress& progress = {});

}  // namespace trivet::fem
