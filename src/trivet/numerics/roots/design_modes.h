// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/numerics/roots/designs.h"

namespace trivet::numerics {

/// Modes K φ = λ A φ of many designs. A is positive definite where `definite`; elsewhere, and where a number is not
/// finite, nothing was solved and all numbers of that row are NaN.
struct DesignModes {
  Eigen::ArrayXXd lambda;  ///< designs × n, ascending
  Eigen::ArrayXXd
      shapes;  ///< designs × n², component i of mode k at k n + i, φᵀAφ = 1, sign free; empty if not asked for
  std::vector<char> definite;  ///< by design
};

struct DesignModesOptions {
  bool shapes = true;
  int threads = 0;  ///< 0: as many as the machine has
  foundation::Progress progress = {};
};

/// By Cholesky with a verdict on the definiteness of each A (scaled to a unit diagonal, Σ 1/eigenvalue < 1/(8 n ε)) and
/// cyclic Jacobi, a design per lane up to n = 12, above one by one. Small λ beside large ones keep their digits. Needs
/// A and K only.
[[nodiscard]] DesignModes design_modes(const Designs& designs, const DesignModesOptions& options = {});
/// The same into memory that can be used again: fresh memory takes as long to reach as the modes themselves.
void design_modes(const Designs& designs, DesignModes& result, const DesignModesOptions& options = {});

}  // namespace trivet::numerics
