// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace trivet::numerics {

/// A piece of the frequency axis on which the Taylor series of every response about `centre` converges like 0.4ʲ.
struct Panel {
  double centre = 0;   ///< [rad/s]; meaningless at infinity
  double radius = 0;   ///< [rad/s], or [s/rad] of 1/ω at infinity
  bool at_infinity = false;
};

/// Ratio of a panel's radius to the distance of its centre from the nearest pole.
inline constexpr double panel_ratio = 0.4;
/// A pole on the axis itself is approached to this relative distance.
inline constexpr double gap_at_pole = 1e-7;

/// A load with delays turns the response like e^{−iω delay}: panels stay short against 1/delay, and there is no panel at infinity.
struct DelayedLoad {
  double longest_delay = 0;   ///< [s]; 0: none
  double highest = 0;         ///< where the cover ends then [rad/s]
};
/// Largest radius × delay of a panel: 5ʲ/j! falls below 1e-16 within the terms kept.
inline constexpr double most_turning = 4;

struct PanelCover {
  std::vector<Panel> panels;               ///< ascending; together with the gaps they cover [lowest, ∞)
  std::vector<double> poles_on_axis;       ///< ω > 0 where an undamped pole stands on the axis [rad/s]
  double lowest = 0;                       ///< 0, or, for a system with rigid motion, 1e-6 of its lowest nonzero |λ|, or 1e-6 rad/s where it has none
};

/// Covers ω ≥ 0 for the poles λ of a response (iω = λ).
[[nodiscard]] PanelCover cover_axis(const Eigen::VectorXcd& poles, const DelayedLoad& delayed = {});

}  // namespace trivet::numerics
