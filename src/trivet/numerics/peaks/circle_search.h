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

/// Values of all curves at one ω, which may be complex; NaN if there is no solution.
struct CurveSample {
  Eigen::VectorXcd values;
  Eigen::VectorXd possible;  ///< possible amplitude: all terms add up in phase
  Eigen::VectorXd
      alike;  ///< the same with every coordinate as large as the largest: round-off of a solution is a share of it
  double condition = 0;  ///< condition number of the equations solved
};

/// @param near  real ω [rad/s] on the same smooth piece of the curves
using CurveSampler = std::function<CurveSample(std::complex<double> omega, double near)>;

struct CircleSearchOptions {
  double from = 0;                   ///< > 0 [rad/s]
  double to = 0;                     ///< [rad/s]
  std::vector<double> seams = {};    ///< ω between two smooth pieces of the curves [rad/s]
  Eigen::VectorXcd near_poles = {};  ///< iω = λ; used only for the first guess of panel sizes
  foundation::Progress progress = {};
  std::function<std::string(Eigen::Index)> name = {};  ///< name of a curve for messages; its number if empty
};

/// Relative accuracy of series from circles: truncation, and the effect of poles just outside.
inline constexpr double circle_accuracy = 1e-10;

/// All extrema of curves of which only values are known. A panel is accepted if samples on a circle around it give a
/// decaying series without principal part; otherwise it is halved.
/// @throws foundation::NotComputable if no panel is accepted over a stretch of the axis, or after 20,000 trials plus 16
/// for each seam
[[nodiscard]] AxisSearch search_by_circles(const CurveSampler& sample, Eigen::Index curves,
                                           const CircleSearchOptions& options);

}  // namespace trivet::numerics
