// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/numerics/roots/designs.h"

namespace trivet::numerics {

/// Modes K φ = λ A φ of many designs. Rows of designs that are not `definite` are not solved: all their numbers are
/// NaN.
struct DesignModes {
  Eigen::ArrayXXd lambda;  ///< designs × n, ascending
  Eigen::ArrayXXd
      shapes;  ///< designs × n², component i of mode k at k n + i, φᵀAφ = 1, sign arbitrary; empty if not requested
  std::vector<char> definite;  ///< per design: A is positive definite, A and K are finite
};

struct DesignModesOptions {
  bool shapes = true;
  int threads = 0;  ///< 0: as many as the machine has
  foundation::Progress progress = {};
};

/// Cholesky, a check that each A is definite (scaled to a unit diagonal, Σ 1/eigenvalue < 1/(8 n ε)), and cyclic
/// Jacobi; one design per lane up to n = 12, otherwise one design at a time. Small λ keep their digits next to large
/// ones. Only A and K are used.
[[nodiscard]] DesignModes design_modes(const Designs& designs, const DesignModesOptions& options = {});
/// The same with reusable memory: the first access to fresh memory takes as long as the modes themselves.
void design_modes(const Designs& designs, DesignModes& result, const DesignModesOptions& options = {});

}  // namespace trivet::numerics
