// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "trivet/nonlinear/balance/steady_equations.h"

namespace trivet::nonlinear {

/// The motion at which a branch begins: by Newton's method from the linear motion; where that does not converge, from a
/// raised load or raised nonlinear forces, or from larger motions.
/// @param branch  of the equations
[[nodiscard]] std::optional<numerics::BranchPoint> first_motion(const SteadyEquations& equations,
                                                                const numerics::Branch& branch, double parameter);

/// Motions at a parameter on the path over the load, from a small one through its folds.
[[nodiscard]] std::vector<numerics::BranchPoint> motions_over_load(const SteadyEquations& equations,
                                                                   const numerics::Branch& branch, double parameter,
                                                                   double most_load);

}  // namespace trivet::nonlinear
