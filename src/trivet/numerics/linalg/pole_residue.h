// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::numerics {

/// Z(s)⁻¹ v_j for constant right sides v_j: Σ_k shapes_k participation_kj / (s − λ_k) + free_motion_j / s² +
/// static_part_j, with Z(s) = s²A + sB + K + iK_loss. Undamped rigid-body modes are the double pole at 0. Valid only if
/// no other pole is defective; this is not checked here, so compare with direct solutions.
struct PoleResidueForm {
  Eigen::VectorXcd poles;          ///< conjugate pairs are adjacent unless there is a loss factor
  Eigen::MatrixXcd shapes;         ///< n × poles
  Eigen::MatrixXcd participation;  ///< poles × right sides
  Eigen::MatrixXcd free_motion;    ///< n × right sides
  Eigen::MatrixXcd static_part;    ///< n × right sides: coordinates with stiffness only
};

/// Symmetric systems with definite mass are solved in their undamped modes, where modal damping gives one quadratic
/// equation per mode; the others by the eigenproblem of their states.
/// @throws foundation::NotComputable if an eigensolver does not converge, or a coordinate without mass is not supported
/// by stiffness or damping
[[nodiscard]] PoleResidueForm pole_residue_form(const DynamicMatrices& matrices, const Eigen::MatrixXcd& right_sides);

}  // namespace trivet::numerics
