// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "trivet/nonlinear/steady_branch.h"

namespace trivet::nonlinear {

/// Stable motions of a curve and of its further ones, and folds beside a stable point, which are their ends.
[[nodiscard]] std::vector<const SteadyPoint*> stable_points(const SteadyBranch& branch);

/// Stretches of the parameter, between the ends of the branch, in which no motion of a known curve is stable.
[[nodiscard]] std::vector<std::pair<double, double>> without_stable_motion(const SteadyBranch& branch);

}  // namespace trivet::nonlinear
