// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <vector>

namespace trivet::numerics {

/// A local extremum of |y(ω)| at ω > 0.
struct Extremum {
  double angular_frequency = 0;  ///< [rad/s]
  double amplitude =
      0;  ///< infinite at an undamped natural frequency; of a minimum near 0 only to the square root of round-off
  bool maximum = false;
  double reach = 0;        ///< radius of the panel it was found on [rad/s]
  double uncertainty = 0;  ///< [rad/s]
};

/// Ascending, and of neighbours of one kind (an extremum seen from two panels) only the more extreme.
[[nodiscard]] std::vector<Extremum> alternating(std::vector<Extremum> all);

/// What a search along the axis tells of one curve.
struct SearchedCurve {
  std::vector<Extremum> extrema;  ///< alternating, undamped poles among them
  double at_start = 0;            ///< |y| at the ends of the search, NaN where Z is singular
  double at_end = 0;              ///< at an infinite end the limit
  double largest_share = 0;       ///< of |y| in what the coordinates could make of it
  bool complete = true;           ///< false: somewhere no series could be had
};

/// A curve below this share of what its coordinates could make of it is zero but for round-off.
inline constexpr double vanishing_share = 1e-12;

/// Heights along a curve from its start through its extrema to its end.
struct CurveHeights {
  std::vector<double> along;  ///< infinite where Z is singular
  double highest = 0;
  double highest_at = 0;  ///< [rad/s], the first of equals
  double finite_top = 0;  ///< the highest that is finite: the scale of its peaks
};

/// @param from, to        the ends of the search [rad/s]
/// @param start_is_scale  false: towards a free motion or an unbounded motion of the ground a curve may rise without
/// end, which is no scale for its peaks
[[nodiscard]] CurveHeights heights_of(const SearchedCurve& curve, double from, double to, bool start_is_scale = true);

/// All extrema of some curves.
struct AxisSearch {
  std::vector<SearchedCurve> curves;
  double from = 0;  ///< [rad/s]; above what was asked where a response has no limit at rest
  double to = std::numeric_limits<double>::infinity();
  int panels = 0;  ///< pieces of the axis, each with its own series
};

/// Frequencies on both sides of an undamped pole …
[[nodiscard]] std::array<double, 4> around_pole(double pole);
/// … and whether |y| there grows like 1/distance: then it is a maximum without bound.
[[nodiscard]] bool is_unbounded(const std::array<double, 4>& amplitudes);

/// That maximum.
[[nodiscard]] Extremum unbounded_at(double pole);

}  // namespace trivet::numerics
