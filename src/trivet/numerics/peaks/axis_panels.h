// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace trivet::numerics {

/// A piece of the frequency axis on which the Taylor series of every response about `centre` converges like 0.4ʲ.
struct Panel {
  double centre = 0;  ///< [rad/s]; meaningless at infinity
  double radius = 0;  ///< [rad/s], or [s/rad] of 1/ω at infinity
  bool at_infinity = false;
};

/// Ratio of a panel's radius to the distance of its centre from the nearest pole.
inline constexpr double panel_ratio = 0.4;
/// A pole on the axis itself is approached to this relative distance.
inline constexpr double gap_at_pole = 1e-7;

/// What a load adds to the poles of a system.
struct CoverOptions {
  bool unbounded_at_rest = false;  ///< given by an acceleration, it grows without end at ω = 0: a pole there
  double longest_delay = 0;  ///< [s]; the response turns like e^{−iω delay}: panels stay short against 1/delay, and
                             ///< there is none at infinity
  double highest = 0;        ///< where the cover ends then [rad/s]
};
/// Largest radius × delay of a panel: 5ʲ/j! falls below 1e-16 within the terms kept.
inline constexpr double most_turning = 4;

struct PanelCover {
  std::vector<Panel> panels;          ///< ascending; together with the gaps they cover [lowest, ∞)
  std::vector<double> poles_on_axis;  ///< ω > 0 where an undamped pole stands on the axis [rad/s]
  double lowest = 0;  ///< where the cover begins [rad/s]: at 0, or far below the lowest nonzero |λ| where the system is
                      ///< free to move or its load unbounded at rest
};

/// Covers ω ≥ 0 for the poles λ of a response (iω = λ).
[[nodiscard]] PanelCover cover_axis(const Eigen::VectorXcd& poles, const CoverOptions& load = {});

}  // namespace trivet::numerics
