// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/model/system.h"

namespace trivet::nonlinear {

/// A motion of vanishing amplitude about rest from which a nonlinear mode begins.
struct ModeAtRest {
  double angular_frequency = 0;  ///< [rad/s]
  Eigen::VectorXd shape;         ///< free coordinates, φᵀAφ = 1
};

/// Ascending. Directions without a stiffness at rest that deflect nonlinear parts come first: they have a frequency as
/// soon as they move. They are in the order of their stiffnesses over a small deflection.
/// @param system   about rest, with tangents
/// @param holding  a stiffness of the machine that holds all that nonlinear parts hold somewhere
[[nodiscard]] std::vector<ModeAtRest> modes_at_rest(const model::System& system, const assembly::Assembled& assembled,
                                                    const Eigen::MatrixXd& holding);

}  // namespace trivet::nonlinear
