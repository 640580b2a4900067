// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/nonlinear/laws/laws_along.h"
#include "trivet/numerics/periodic/linear_flow.h"

namespace trivet::nonlinear {

/// How the deflections answer the forces of the nonlinear parts, deflections × forces. A node without mass follows them
/// at once if stiffness alone holds it, and drifts if dampers do.
struct DeflectionAnswers {
  Eigen::MatrixXd at_once;  ///< D: deflections by forces
  Eigen::MatrixXd drifts;   ///< E: rates by forces
  Eigen::MatrixXd rates;    ///< R: rates by impulses on masses, or accelerations by forces
  bool massless = false;    ///< is any entry of D or E not zero?

  /// I − S_d (D + E h/2) − S_r (E + R h/2): times the mean forces of a step h it is the forces by the states before it,
  /// with the tangents S_d of the laws by deflections and S_r by rates (implicit midpoint rule).
  [[nodiscard]] Eigen::MatrixXd left_side(const Eigen::MatrixXd& by_deflection, const Eigen::MatrixXd& by_rate,
                                          double step) const;
};

/// What the laws answer in the middle of each step: forces, times the step, and below them the changes of bristles
/// and of the direction of rubbing contacts, by the values of all deflections, their rates if there are dampers, and
/// the memories of loops, rubbing contacts and bristles.
[[nodiscard]] numerics::RowMatrix answers_of_laws(const LawsAlong& motion, const DeflectionAnswers& answers,
                                                  double from, double to, int steps);

/// One unit of a memory of a rubbing contact: the spring's force over the travel for which its frequency alone with the
/// mass is the rate, so that all states have one size.
/// @param accelerations  of each deflection per unit of its force
[[nodiscard]] Eigen::VectorXd units_of_friction(const LawsAlong& motion, const Eigen::VectorXd& accelerations);

}  // namespace trivet::nonlinear
