// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/nonlinear/laws_along.h"
#include "trivet/numerics/periodic/linear_flow.h"

namespace trivet::nonlinear {

/// What the laws answer in the middle of each step: forces, times the step, and below them the changes of bristles
/// and of the direction of rubbing contacts, by the values of all deflections, their rates if there are dampers, and
/// the memories of loops, rubbing contacts and bristles.
/// @param rates_by_force  rate of each deflection by an impulse of each force
/// @param accelerations   of each deflection per unit of its force
[[nodiscard]] numerics::RowMatrix answers_of_laws(const LawsAlong& motion, const Eigen::MatrixXd& rates_by_force,
                                                  const Eigen::VectorXd& accelerations, double from, double to,
                                                  int steps);

/// One unit of a memory of a rubbing contact: the spring's force over the travel for which its frequency alone with the
/// mass is the rate, so that all states have one size.
[[nodiscard]] Eigen::VectorXd units_of_friction(const LawsAlong& motion, const Eigen::VectorXd& accelerations);

}  // namespace trivet::nonlinear
