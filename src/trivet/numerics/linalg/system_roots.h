// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/quadratic_roots.h"

namespace trivet::numerics {

/// All roots of λ²A + λB + K + iK_loss. Roots with |λ| ≤ at_rest belong to rigid-body modes; at_rest is 0 if the solver
/// separates these modes exactly.
struct SystemRoots {
  QuadraticRoots roots;
  double at_rest = 0;
};

/// The method depends on the matrices: undamped modes alone, states in undamped modes, or states of the matrices
/// themselves; refined in extended precision up to 60 coordinates. Some coordinates may have no mass.
/// @throws foundation::NotComputable if an eigensolver does not converge, or a coordinate without mass has no stiffness
[[nodiscard]] SystemRoots system_roots(const DynamicMatrices& matrices);

/// Poles of any response at iω = λ; those of rigid-body modes are exactly 0.
[[nodiscard]] Eigen::VectorXcd poles(const SystemRoots& of);

}  // namespace trivet::numerics
