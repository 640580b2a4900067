// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::numerics {

/// Roots λ and vectors v of a quadratic eigenproblem (λ²A + λB + K + iK_loss) v = 0.
struct QuadraticRoots {
  Eigen::VectorXcd lambda;
  Eigen::MatrixXcd vectors;  ///< n × count, largest component (A-weighted) equal to 1
};

/// Roots from the state matrix in coordinates where A = 1 and K = diag(ω²): [0 Ω; −Ω − iK_loss Ω⁻¹, −B]. Coordinates
/// with ω = 0 give exact zero roots; if also undamped, they give two each and are excluded from the state matrix.
[[nodiscard]] QuadraticRoots roots_in_modal_basis(const Eigen::VectorXd& omega, const Eigen::MatrixXd& B,
                                                  const Eigen::MatrixXd& K_loss);

/// Roots of general matrices (unsymmetric or indefinite allowed) from the states (q, q̇, z): one root for each
/// coordinate z without mass (internal ones of elements, with a regular block of B), two for each other coordinate.
[[nodiscard]] QuadraticRoots roots_from_states(const DynamicMatrices& matrices);

/// Refines each nonzero root by Newton steps in extended precision (long double): with light damping a double
/// eigensolver leaves few digits of Re λ. Roots without small, convergent steps (clusters, defective pairs) are
/// unchanged. Cost O(count n³): meant for n ≤ 60.
void refine_roots(const DynamicMatrices& matrices, QuadraticRoots& roots);

}  // namespace trivet::numerics
