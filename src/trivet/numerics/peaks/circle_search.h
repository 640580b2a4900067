// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/numerics/peaks/extremum.h"

namespace trivet::numerics {

/// All curves at one ω, which may be complex; NaN where there is no answer.
struct CurveSample {
  Eigen::VectorXcd values;
  Eigen::VectorXd possible;  ///< the same if all terms worked together
  Eigen::VectorXd
      alike;  ///< the same if all coordinates moved as much as the largest: round-off of a solution is a share of that
  double condition = 0;  ///< of what was solved
};

/// @param near  real ω [rad/s] of the same smooth piece of the curves
using CurveSampler = std::function<CurveSample(std::complex<double> omega, double near)>;

struct CircleSearchOptions {
  double from = 0;                   ///< > 0 [rad/s]
  double to = 0;                     ///< [rad/s]
  std::vector<double> seams = {};    ///< where one smooth piece of the curves ends and the next begins [rad/s]
  Eigen::VectorXcd near_poles = {};  ///< iω = λ; only guides the first guess of panel sizes
  foundation::Progress progress = {};
  std::function<std::string(Eigen::Index)> name = {};  ///< of a curve, for messages; its number if there is none
};

/// Relative accuracy of series taken from circles: where they are cut, and what poles just outside leave.
inline constexpr double circle_accuracy = 1e-10;

/// All extrema of curves that are known by their values alone. Each panel proves itself: samples on a circle around it
/// must have no principal part and a decaying series; until then it shrinks.
/// @throws foundation::NotComputable where no panel can be had over a stretch of the axis, or after 20,000 trials and
/// 16 for each seam
[[nodiscard]] AxisSearch search_by_circles(const CurveSampler& sample, Eigen::Index curves,
                                           const CircleSearchOptions& options);

}  // namespace trivet::numerics
