// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/general_eigen.h"

namespace trivet::numerics {

/// First-order form of A q̈ + B q̇ + (K + iK_loss) q = h: ẋ = state · x + input, q = output · x.
struct StateForm {
  Eigen::MatrixXcd state, input, output;
  bool real = true;  ///< the state matrix has no imaginary part
};

/// States (q, q̇, z), scaled; z are the coordinates without mass, which need a regular block of B.
/// Not finite if that block or the mass matrix of the others is singular.
[[nodiscard]] StateForm state_form(const DynamicMatrices& matrices, const Eigen::MatrixXcd& right_sides);

/// @throws foundation::NotComputable if the eigensolver does not converge
[[nodiscard]] GeneralEigen eigen_of_states(const StateForm& form);

}  // namespace trivet::numerics
