// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/nonlinear/bristle_loop.h"

namespace trivet::nonlinear {

/// Fourier coefficients of the force of bristles beyond that at the state, and their derivatives; first coefficients
/// are doubled.
struct BristleHarmonics {
  Eigen::VectorXd force;
  Eigen::MatrixXd tangent;   ///< by the coefficients of the deflection; empty if not asked for
  Eigen::VectorXd by_omega;  ///< the same
};
/// @param deflection  that of the loop
[[nodiscard]] BristleHarmonics bristle_harmonics(const BristleLoop& loop, const Eigen::VectorXd& deflection,
                                                 double omega, bool with_tangent);

/// The force at the frequencies μ + k, k = −K … K, by a variation e^{i(μ + l)φ} of the deflection.
[[nodiscard]] Eigen::MatrixXcd bristle_variation(const BristleLoop& loop, double mu, double omega,
                                                 Eigen::Index harmonics);

}  // namespace trivet::nonlinear
