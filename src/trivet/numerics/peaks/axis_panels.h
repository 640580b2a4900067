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

/// Properties of a load that change the cover.
struct CoverOptions {
  bool unbounded_at_rest = false;  ///< infinite at ω = 0, e.g. a motion given by its acceleration: a pole there
  double longest_delay = 0;        ///< [s]; response with e^{−iω delay}: short panels against 1/delay, none at infinity
  double highest = 0;              ///< end of the cover of a delayed load [rad/s]
};
/// Largest radius × delay of a panel: 5ʲ/j! falls below 1e-16 within the terms kept.
inline constexpr double most_turning = 4;

struct PanelCover {
  std::vector<Panel> panels;          ///< ascending; together with the gaps they cover [lowest, ∞)
  std::vector<double> poles_on_axis;  ///< ω > 0 of the undamped poles on the axis [rad/s]
  double lowest = 0;  ///< start of the cover [rad/s]: 0, or far below the lowest nonzero |λ| if the system has
                      ///< rigid-body modes or its load is unbounded at rest
};

/// Covers ω ≥ 0 for the poles λ of a response (iω = λ).
[[nodiscard]] PanelCover cover_axis(const Eigen::VectorXcd& poles, const CoverOptions& load = {});

}  // namespace trivet::numerics
