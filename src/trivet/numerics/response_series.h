// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/dynamic_matrices.h"

namespace trivet::numerics {

/// Taylor coefficients of q(ω) = Z(ω)⁻¹ h about `centre`: q(centre + radius τ) = Σ_j column_j τʲ, j = 0 … order.
/// From one factorisation by Z₀q_j = h_j − Z₁q_{j−1} − Z₂q_{j−2}; converges for |τ| < (distance to the nearest pole)/radius,
/// also where poles are defective. centre > 0, or 0 if Z(0) is regular.
[[nodiscard]] Eigen::MatrixXcd response_series(const DynamicMatrices& matrices, const Eigen::VectorXcd& load, double centre,
                                               double radius, int order);

/// The same about ω = ∞ in s = 1/ω: q = s² p(s), p(s) = (s²(K + iK_loss) + isB − A)⁻¹ h; coefficients of p(radius τ).
/// A row without mass must have damping there, and no load.
[[nodiscard]] Eigen::MatrixXcd response_series_at_infinity(const DynamicMatrices& matrices, const Eigen::VectorXcd& load, double radius,
                                                           int order);

}  // namespace trivet::numerics
