// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::numerics {

/// Z(s)⁻¹ v_j for constant right sides v_j: Σ_k shapes_k participation_kj / (s − λ_k) + free_motion_j / s² +
/// static_part_j, with Z(s) = s²A + sB + K + iK_loss. Undamped free motions are the double pole at 0. It holds only
/// where no other pole is defective: nothing here tells, so hold it to direct solutions.
struct PoleResidueForm {
  Eigen::VectorXcd poles;          ///< conjugate pairs stand one after the other unless there is a loss factor
  Eigen::MatrixXcd shapes;         ///< n × poles
  Eigen::MatrixXcd participation;  ///< poles × right sides
  Eigen::MatrixXcd free_motion;    ///< n × right sides
  Eigen::MatrixXcd static_part;    ///< n × right sides: coordinates held by stiffness only
};

/// Symmetric systems with definite mass are taken in their undamped modes, where modal damping leaves a quadratic
/// equation for each; the others by the eigenproblem of their states.
/// @throws foundation::NotComputable if an eigensolver does not converge or a coordinate is held by nothing
[[nodiscard]] PoleResidueForm pole_residue_form(const DynamicMatrices& matrices, const Eigen::MatrixXcd& right_sides);

}  // namespace trivet::numerics
