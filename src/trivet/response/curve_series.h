// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/numerics/axis_panels.h"
#include "trivet/numerics/response_series.h"

namespace trivet::response {

/// Terms kept of every Taylor series: 0.4³⁶ ≈ 5e-15.
inline constexpr int series_order = 36;

/// |y|² of one curve on one panel as a power series in τ ∈ [−1, 1], ω = centre + radius τ. At infinity 1/ω = radius τ,
/// τ ∈ (0, 1], and |y|² = (1/ω)^(2 power) Σ square[k] τᵏ; a negative power grows without end.
struct CurveSeries {
  std::vector<double> square;
  int power = 0;
};

/// Taylor coefficients (columns) of the free and the ground coordinates on a panel; powers of 1/ω before them at infinity, else 0.
struct CoordinateSeries {
  numerics::SeriesAtInfinity free;
  numerics::SeriesAtInfinity ground;   ///< no rows if the ground rests
};

[[nodiscard]] CoordinateSeries coordinate_series(const numerics::DynamicMatrices& matrices, const numerics::Load& right_side,
                                                 const numerics::Load& ground_motion, const numerics::Panel& panel);

[[nodiscard]] CurveSeries curve_series(const assembly::Channel& channel, const numerics::Panel& panel, const CoordinateSeries& coordinates);

/// A polynomial with the sign of d|y|²/dτ for τ > 0 at infinity, everywhere else of d|y|²/dτ itself.
[[nodiscard]] std::vector<double> slope(const CurveSeries& series);

/// |y| at τ.
[[nodiscard]] double amplitude(const CurveSeries& series, const numerics::Panel& panel, double tau);

/// ω at τ [rad/s].
[[nodiscard]] double angular_frequency(const numerics::Panel& panel, double tau);

}  // namespace trivet::response
