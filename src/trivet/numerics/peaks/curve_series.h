// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/numerics/peaks/axis_panels.h"
#include "trivet/numerics/peaks/extremum.h"
#include "trivet/numerics/peaks/observed_curve.h"
#include "trivet/numerics/peaks/response_series.h"

namespace trivet::numerics {

/// |y|² of one curve on one panel as a power series in τ ∈ [−1, 1], ω = centre + radius τ. At infinity 1/ω = radius τ,
/// τ ∈ (0, 1], and |y|² = (1/ω)^(2 power) Σ square[k] τᵏ; a negative power grows without end.
struct CurveSeries {
  std::vector<double> square;
  int power = 0;
};

/// Taylor coefficients (columns) of the response and of what is given on a panel; powers of 1/ω before them at
/// infinity, else 0.
struct CoordinateSeries {
  SeriesAtInfinity response;
  SeriesAtInfinity given;  ///< no rows if nothing is
};

[[nodiscard]] CoordinateSeries coordinate_series(const DynamicMatrices& matrices, const Load& load, const Load& given,
                                                 const Panel& panel);

[[nodiscard]] CurveSeries curve_series(const ObservedCurve& curve, const Panel& panel,
                                       const CoordinateSeries& coordinates);

/// |y|² of a curve whose own coefficients are known.
[[nodiscard]] CurveSeries squared_modulus(const Eigen::RowVectorXcd& coefficients, int power = 0);

/// A bound on |y| but for powers of 1/ω.
[[nodiscard]] double size_of(const CurveSeries& series);

/// |y| at τ.
[[nodiscard]] double amplitude(const CurveSeries& series, const Panel& panel, double tau);

/// Its limit at the end of a panel at infinity; leading coefficients that are round-off do not count.
[[nodiscard]] double limit_at_infinity(const CurveSeries& series, const Panel& panel);

/// d|y|²/dω at τ, on a panel that is not at infinity.
[[nodiscard]] double rise_of_square(const CurveSeries& series, const Panel& panel, double tau);

/// Adds all extrema of |y| on the panel and strictly between two frequencies [rad/s].
void add_extrema(const CurveSeries& series, const Panel& panel, double from, double to, std::vector<Extremum>& extrema);

}  // namespace trivet::numerics
