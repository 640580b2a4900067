// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/study/analyses/case_context.h"
#include "trivet/study/family/design_neighbours.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {

/// Derivatives of ln|y| at fixed frequencies, frequencies × parameters: y = cᵀq with Zq = h gives
/// dy = λᵀ(dh − dZ q) + dcᵀq with Zᵀλ = c. At a maximum of |y| its shift does not count.
/// @param result  names the curve
/// @param frequencies  [rad/s]; 0 stands for the limit at rest
[[nodiscard]] Eigen::MatrixXd curve_slopes(const CaseContext& context, const DesignNeighbours& neighbours,
                                           const RequirementResult& result, const std::vector<double>& frequencies);

}  // namespace trivet::study
