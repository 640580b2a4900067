// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/load.h"
#include "trivet/numerics/peaks/extremum.h"

namespace trivet::numerics {

/// Z(s) q = load(s), and the prescribed motion that curves may contain.
struct DrivenSystem {
  const DynamicMatrices& matrices;
  const Load& load;
  const Load& given;  ///< prescribed motion; without terms if there is none
};

struct DiscSearchOptions {
  double from = 0;                                      ///< [rad/s]
  double to = std::numeric_limits<double>::infinity();  ///< [rad/s]; finite if the load is delayed: extrema up to one
                                                        ///< panel beyond are then reported too
  foundation::Progress progress = {};
};

/// All extrema of |y| strictly inside a band: discs free of poles cover the axis; on each, |y|² is a Taylor series, and
/// bisection with bounds finds the sign changes of its derivative. Poles only determine the size of the discs, so that
/// defective poles do no harm.
/// @param poles  all poles of the response, iω = λ
[[nodiscard]] AxisSearch search_by_discs(const DrivenSystem& system, const std::vector<ObservedCurve>& curves,
                                         const Eigen::VectorXcd& poles, const DiscSearchOptions& options = {});

}  // namespace trivet::numerics
