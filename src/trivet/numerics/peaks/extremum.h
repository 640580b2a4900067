// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <complex>
#include <limits>
#include <optional>
#include <vector>

namespace trivet::numerics {

/// A local extremum of |y(ω)| at ω > 0.
struct Extremum {
  double angular_frequency = 0;  ///< [rad/s]
  double amplitude = 0;  ///< infinite at an undamped natural frequency; a minimum near 0 is accurate only to √round-off
  bool maximum = false;
  double reach = 0;        ///< radius of the panel it was found on [rad/s]
  double uncertainty = 0;  ///< [rad/s]
};

/// Extrema by ascending frequency; of neighbours of one kind (the same extremum found on two panels) only the more
/// extreme.
[[nodiscard]] std::vector<Extremum> alternating(std::vector<Extremum> all);

/// Result of a search along the axis for one curve.
struct SearchedCurve {
  std::vector<Extremum> extrema;  ///< alternating, including undamped poles
  double at_start = 0;            ///< |y| at the ends of the search, NaN if Z is singular
  double at_end = 0;              ///< at an infinite end the limit
  double largest_share = 0;       ///< largest ratio of |y| to its possible amplitude (all terms in phase)
  bool complete = true;           ///< false if a panel has no series
};

/// A curve below this share of its possible amplitude is zero except for round-off.
inline constexpr double vanishing_share = 1e-12;

/// Heights along a curve from its start through its extrema to its end.
struct CurveHeights {
  std::vector<double> along;  ///< infinite if Z is singular
  double highest = 0;
  double highest_at = 0;  ///< [rad/s], the lowest if several are equal
  double finite_top = 0;  ///< the highest finite one: the scale of its peaks
};

/// @param from, to        the ends of the search [rad/s]
/// @param start_is_scale  false if the curve may grow without bound at its start (rigid-body mode, unbounded ground
/// motion), which gives no scale for its peaks
[[nodiscard]] CurveHeights heights_of(const SearchedCurve& curve, double from, double to, bool start_is_scale = true);

/// All extrema of some curves.
struct AxisSearch {
  std::vector<SearchedCurve> curves;
  double from = 0;  ///< [rad/s]; above the requested one if a response has no limit at rest
  double to = std::numeric_limits<double>::infinity();
  int panels = 0;  ///< pieces of the axis, each with its own series
};

/// Four frequencies [rad/s] around an undamped pole, ascending.
[[nodiscard]] std::array<double, 4> around_pole(double pole);
/// Whether |y| at these frequencies grows like 1/distance, so that the maximum is infinite.
[[nodiscard]] bool is_unbounded(const std::array<double, 4>& amplitudes);

/// The infinite maximum at an undamped pole.
[[nodiscard]] Extremum unbounded_at(double pole);

/// The finite maximum of a curve without that pole, but with a damped one next to it: no panel reaches there. From
/// 1/|y|² at the four frequencies, which is a parabola near one pole. Empty if the curve has no maximum there.
[[nodiscard]] std::optional<Extremum> bounded_at(double pole, const std::array<double, 4>& amplitudes);

/// Linear form (on_displacement + s on_velocity + s² on_acceleration)ᵀ x of coordinates x, s = iω. If the vectors are
/// longer than x, only their first rows count.
struct CurveTerms {
  Eigen::VectorXcd on_displacement;
  Eigen::VectorXd on_velocity, on_acceleration;
  [[nodiscard]] bool empty() const { return on_displacement.size() == 0; }
};

/// y = s^derivative (terms of the response q + terms of the prescribed motion), s = iω.
struct ObservedCurve {
  CurveTerms of_response;
  CurveTerms of_given;  ///< empty if it adds nothing
  int derivative = 0;
};

/// A curve with real terms, for the kernels that solve many designs: y = s^derivative (on_displacement + s
/// on_velocity)ᵀ q, s = iω.
struct ObservedRow {
  Eigen::VectorXd on_displacement;
  Eigen::VectorXd on_velocity;  ///< or empty
  int derivative = 0;
};

[[nodiscard]] ObservedCurve observed_curve(const ObservedRow& row);

/// Values of the terms for x, one column per ω, which may be complex.
[[nodiscard]] Eigen::RowVectorXcd weighted(const CurveTerms& terms, const Eigen::MatrixXcd& x,
                                           const Eigen::RowVectorXcd& omega);

/// Values of a curve, one per ω. @param given  prescribed motion; no columns if there is none
[[nodiscard]] Eigen::RowVectorXcd curve_values(const ObservedCurve& curve, const Eigen::MatrixXcd& q,
                                               const Eigen::MatrixXcd& given, const Eigen::RowVectorXcd& omega);

/// Possible amplitude: |y| if the terms of coordinates of these sizes all add up in phase; values far below are
/// round-off. @param omega  |ω|
[[nodiscard]] Eigen::RowVectorXd possible_amplitudes(const ObservedCurve& curve, const Eigen::MatrixXd& q,
                                                     const Eigen::MatrixXd& given, const Eigen::RowVectorXd& omega);

}  // namespace trivet::numerics
