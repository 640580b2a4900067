// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/numerics/peaks/axis_panels.h"
#include "trivet/numerics/peaks/extremum.h"
#include "trivet/numerics/peaks/observed_curve.h"
#include "trivet/numerics/peaks/response_series.h"

namespace trivet::numerics {

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
