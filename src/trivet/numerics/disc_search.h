// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/numerics/dynamic_matrices.h"

namespace trivet::numerics {

/// y = s^derivative (on_displacement + s on_velocity)ᵀ q, s = iω.
struct ObservedRow {
  Eigen::VectorXd on_displacement;
  Eigen::VectorXd on_velocity;  ///< or empty
  int derivative = 0;
};

/// A local extremum of |y(ω)| at ω > 0.
struct Extremum {
  double angular_frequency = 0;  ///< [rad/s]
  double amplitude = 0;          ///< infinite at an undamped natural frequency
  bool maximum = false;
};

/// One curve on a band: values at its ends and what lies between, ascending, maxima and minima in turn.
struct BandCurve {
  double at_start = 0;
  double at_end = 0;             ///< the limit if the band has no end
  std::vector<Extremum> extrema;
  bool complete = true;          ///< false: somewhere no series could be had
};

/// All extrema of |y| for from < ω < to (which may be infinite) under a constant real load: the axis is covered by discs free of poles, on each
/// |y|² is a Taylor series whose derivative is searched for sign changes by bisection with bounds. Needs poles only for the size of
/// the discs, so that defective ones do no harm. A must be regular.
[[nodiscard]] std::vector<BandCurve> search_by_discs(const DynamicMatrices& matrices, const Eigen::VectorXd& load, const std::vector<ObservedRow>& rows,
                                                     double from, double to);

}  // namespace trivet::numerics
