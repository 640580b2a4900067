// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/foundation/interruption.h"

namespace trivet::response {

/// A local extremum of |y(ω)|, maximum or minimum, as found on its panel.
struct Turning {
  double angular_frequency = 0;
  double amplitude = 0;
  bool maximum = false;
  double reach = 0;         ///< radius of its panel [rad/s]
  double uncertainty = 0;   ///< [rad/s]
};

/// What one walk along the axis collects for one curve.
struct Walk {
  std::vector<Turning> turnings;
  double largest_share = 0;   ///< of |y| in what the coordinates could make of it
  double start = 0, end = 0;  ///< |y| at the lowest frequency and at the end of the axis
};

struct AxisWalk {
  std::vector<Walk> curves;
  std::vector<double> poles_on_axis;   ///< undamped poles, each with a gap around it [rad/s]
  double lowest = 0, highest = std::numeric_limits<double>::infinity();  ///< [rad/s]
  int panels = 0;
};

/// A curve below this share of what its coordinates could make of it is zero but for round-off.
inline constexpr double vanishing_share = 1e-12;
/// Relative accuracy of series taken from circles: where they are cut, and what poles just outside leave.
inline constexpr double contour_accuracy = 1e-10;

/// All extrema of all curves on 0 ≤ ω ≤ ∞, on panels laid out by the poles of the response; up to `highest` if the load is delayed.
[[nodiscard]] AxisWalk walk_by_poles(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                                     const assembly::Loading& loading, const Eigen::VectorXcd& poles, double highest, const foundation::Progress& progress);

/// All extrema up to `highest` of systems with frequency-dependent elements. `near_poles` only guide the first guess of panel sizes; each panel
/// proves itself: samples on a circle around it must have no principal part and a decaying series.
[[nodiscard]] AxisWalk walk_by_contours(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                                        const assembly::Loading& loading, const Eigen::VectorXcd& near_poles, double highest,
                                        const foundation::Progress& progress);

}  // namespace trivet::response
