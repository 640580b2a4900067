// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/quadratic_roots.h"

namespace trivet::numerics {

/// All roots of λ²A + λB + K + iK_loss, and how small one must be to stand for a free motion: exactly 0 where the
/// solver splits free motions off.
struct SystemRoots {
  QuadraticRoots roots;
  double at_rest = 0;
};

/// By the way that suits the matrices: undamped modes alone, the states in undamped modes, those of the matrices as
/// they are; refined in extended precision up to 60 coordinates. Coordinates without mass may be among them.
/// @throws foundation::NotComputable if an eigensolver does not converge or a coordinate is held by nothing
[[nodiscard]] SystemRoots system_roots(const DynamicMatrices& matrices);

/// The poles of any response at iω = λ: free motions exactly 0.
[[nodiscard]] Eigen::VectorXcd poles(const SystemRoots& of);

}  // namespace trivet::numerics
