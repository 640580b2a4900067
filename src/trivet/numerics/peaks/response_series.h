// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/load.h"
#include "trivet/numerics/linalg/sparse_system.h"

namespace trivet::numerics {

/// Taylor coefficients of h(ω) about `centre`: h(centre + radius τ) = Σ_j column_j τʲ, j = 0 … order. With a delay d
/// they decrease like (radius d)ʲ / j!. centre > 0 if the load has negative powers.
[[nodiscard]] Eigen::MatrixXcd load_series(const Load& load, double centre, double radius, int order);

/// A vector about ω = ∞: s^power Σ_j column_j τʲ, s = 1/ω = radius τ.
struct SeriesAtInfinity {
  Eigen::MatrixXcd coefficients;
  int power = 0;
};

/// h(ω) of a load without delays.
[[nodiscard]] SeriesAtInfinity load_series_at_infinity(const Load& load, double radius, int order);

/// Series of the response q(ω) = Z(ω)⁻¹ h(ω) of one system.
class ResponseSeries {
 public:
  ResponseSeries(const DynamicMatrices& matrices, const Load& load);

  /// Taylor coefficients about `centre`: q(centre + radius τ) = Σ_j column_j τʲ, j = 0 … order. Uses one factorisation,
  /// Z₀q_j = h_j − Z₁q_{j−1} − Z₂q_{j−2}; converges for |τ| < (distance to the nearest pole)/radius, also with
  /// defective poles. centre > 0, or 0 if Z(0) is regular.
  [[nodiscard]] Eigen::MatrixXcd about(double centre, double radius, int order) const;

  /// q about ω = ∞. Coordinates without mass may have damping, or stiffness only.
  [[nodiscard]] SeriesAtInfinity at_infinity(double radius, int order) const;

 private:
  Eigen::VectorXd scale_;
  DynamicMatrices matrices_;  ///< in coordinates of unit mass diagonal
  Load load_;
  SparseSystem system_;
};

}  // namespace trivet::numerics
