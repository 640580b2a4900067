// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/load.h"
#include "trivet/numerics/linalg/sparse_system.h"
#include "trivet/numerics/peaks/axis_panels.h"
#include "trivet/numerics/peaks/extremum.h"

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

/// |y|² of one curve on one panel as a power series in τ ∈ [−1, 1], ω = centre + radius τ. At infinity 1/ω = radius τ,
/// τ ∈ (0, 1], and |y|² = (1/ω)^(2 power) Σ square[k] τᵏ; with a negative power it grows without bound.
struct CurveSeries {
  std::vector<double> square;
  int power = 0;
};

/// Taylor coefficients (columns) of the response and of the prescribed motion on a panel, with their leading powers of
/// 1/ω at infinity, else 0.
struct CoordinateSeries {
  SeriesAtInfinity response;
  SeriesAtInfinity given;  ///< prescribed motion; no rows if there is none
};

[[nodiscard]] CoordinateSeries coordinate_series(const ResponseSeries& response, const Load& given, const Panel& panel);

[[nodiscard]] CurveSeries curve_series(const ObservedCurve& curve, const Panel& panel,
                                       const CoordinateSeries& coordinates);

/// |y|² from the Taylor coefficients of y.
[[nodiscard]] CurveSeries squared_modulus(const Eigen::RowVectorXcd& coefficients, int power = 0);

/// Size of |y| except for powers of 1/ω: square root of the largest coefficient of |y|².
[[nodiscard]] double size_of(const CurveSeries& series);

/// |y| at τ.
[[nodiscard]] double amplitude(const CurveSeries& series, const Panel& panel, double tau);

/// Limit of |y| for ω → ∞ on a panel at infinity; leading coefficients that are round-off are ignored.
[[nodiscard]] double limit_at_infinity(const CurveSeries& series, const Panel& panel);

/// d|y|²/dω at τ, not for a panel at infinity.
[[nodiscard]] double rise_of_square(const CurveSeries& series, const Panel& panel, double tau);

/// Adds all extrema of |y| on the panel and strictly between two frequencies [rad/s].
void add_extrema(const CurveSeries& series, const Panel& panel, double from, double to, std::vector<Extremum>& extrema);

}  // namespace trivet::numerics
