// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "trivet/nonlinear/laws/law_set.h"

namespace trivet::nonlinear {

/// Why a curve of motions may end after its last one: a stop that is just touched, friction that begins to slip, turns
/// more often, or finds no closed loop. "; the stop …", or nothing.
/// @param motion  Fourier coefficients × deflections
/// @param beyond  those of the next motion, as guessed
/// @param omega   of the first harmonic [rad/s]
[[nodiscard]] std::string end_reason(const std::vector<Deflection>& deflections, const LawSet& laws,
                                     const Eigen::MatrixXd& motion, const Eigen::MatrixXd& beyond, double omega);

}  // namespace trivet::nonlinear
