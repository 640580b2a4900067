// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/load.h"
#include "trivet/numerics/peaks/extremum.h"
#include "trivet/numerics/peaks/observed_curve.h"

namespace trivet::numerics {

/// Z(s) q = load(s), and what else curves are made of.
struct DrivenSystem {
  const DynamicMatrices& matrices;
  const Load& load;
  const Load& given;  ///< without terms if nothing is
};

struct DiscSearchOptions {
  double from = 0;                                      ///< [rad/s]
  double to = std::numeric_limits<double>::infinity();  ///< [rad/s]; finite if the load is delayed: then extrema up to
                                                        ///< a panel beyond it are told too
  foundation::Progress progress = {};
};

/// All extrema of |y| strictly inside a band: the axis is covered by discs free of poles, on each |y|² is a Taylor
/// series whose derivative is searched for sign changes by bisection with bounds. Poles are needed only for the size of
/// the discs, so that defective ones do no harm.
/// @param poles  all of the response, iω = λ
[[nodiscard]] AxisSearch search_by_discs(const DrivenSystem& system, const std::vector<ObservedCurve>& curves,
                                         const Eigen::VectorXcd& poles, const DiscSearchOptions& options = {});

}  // namespace trivet::numerics
