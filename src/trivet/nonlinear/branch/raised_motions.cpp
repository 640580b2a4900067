// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/branch/raised_motions.h"

#include <cmath>
#include <utility>

namespace trivet::nonlinear {

using Eigen::VectorXd;
using numerics::BranchPoint;

namespace {

constexpr numerics::StepControl raising_steps{.sharp_turns = 1e-4};

/// The solution at parameter 1 on the branch of a point.
std::optional<BranchPoint> followed_to_one(const numerics::Branch& branch, std::optional<BranchPoint> now) {
  double step = 0.01;
  constexpr int most_points = 2000;
  for (int i = 0; now && i < most_points; ++i) {
    const std::optional<numerics::Branch::Advance> advance = branch.advance(*now, step, raising_steps);
    if (!advance) return std::nullopt;
    if (advance->to.parameter > 1) return branch.at(1, *now, 0, advance->length);
    now = advance->to;
  }
  return std::nullopt;
}

std::optional<BranchPoint> at_small_load(const SteadyEquations& equations, const numerics::Branch& over_load,
                                         double parameter) {
  constexpr double small = 1e-3;
  const Driving whole = equations.driving(parameter);
  return over_load.start(equations.balance().linear_motion({whole.omega, small * whole.factor}), small);
}

}  // namespace

std::optional<BranchPoint> first_motion(const SteadyEquations& equations, const numerics::Branch& branch,
                                        double parameter) {
  const VectorXd linear = equations.balance().linear_motion(equations.driving(parameter));
  if (std::optional<BranchPoint> found = branch.start(linear, parameter)) return found;
  const numerics::Branch over_load = equations.over_load(parameter);
  if (const auto raised = followed_to_one(over_load, at_small_load(equations, over_load, parameter)))
    if (std::optional<BranchPoint> found = branch.start(raised->unknowns, parameter)) return found;
  const numerics::Branch over_forces = equations.over_nonlinear_forces(parameter);
  if (const auto raised = followed_to_one(over_forces, over_forces.start(linear, 0)))
    if (std::optional<BranchPoint> found = branch.start(raised->unknowns, parameter)) return found;
  // A force that jumps as friction breaks away cannot be raised.
  for (const double larger : {1.5, 2.0, 3.0, 5.0})
    if (std::optional<BranchPoint> found = branch.start(larger * linear, parameter)) return found;
  return std::nullopt;
}

std::vector<BranchPoint> motions_over_load(const SteadyEquations& equations, const numerics::Branch& branch,
                                           double parameter, double most_load) {
  const numerics::Branch over_load = equations.over_load(parameter);
  constexpr int most_points = 600;
  std::vector<BranchPoint> found;
  std::optional<BranchPoint> now = at_small_load(equations, over_load, parameter);
  double step = 0.02;
  for (int i = 0; now && i < most_points && std::abs(now->parameter) < most_load; ++i) {
    const std::optional<numerics::Branch::Advance> advance = over_load.advance(*now, step, raising_steps);
    if (!advance) break;
    if ((now->parameter < 1) != (advance->to.parameter < 1))
      if (const std::optional<BranchPoint> there = over_load.at(1, *now, 0, advance->length))
        if (std::optional<BranchPoint> motion = branch.start(there->unknowns, parameter))
          found.push_back(std::move(*motion));
    now = advance->to;
  }
  return found;
}

}  // namespace trivet::nonlinear
