// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/spatial/types.h"

namespace trivet::identification {

/// The passive, stress-free matrix nearest to a given symmetric one. Distances are taken per entry, divided by √(C_ii
/// C_jj); a diagonal entry below a thousandth of the mean of its kind (translation, rotation) counts as that
/// thousandth.
struct SemidefiniteMatrix {
  spatial::Matrix12 stiffness;
  double distance = 0;           ///< Frobenius norm of the change / that of the matrix, scaled
  double lowest_eigenvalue = 0;  ///< of the scaled matrix before the change; the largest is of the order of 1
};

/// Nearest positive semidefinite matrix without strain energy in a rigid motion of ends `arm` [m] apart (from N to K).
/// @throws InvalidInput unless the matrix is finite and the means of its translational and rotational diagonals are > 0
[[nodiscard]] SemidefiniteMatrix nearest_semidefinite(const spatial::Matrix12& stiffness, const Eigen::Vector3d& arm);

}  // namespace trivet::identification
