// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>

#include "trivet/nonlinear/rubbing_loop.h"

namespace trivet::nonlinear {

/// Fourier coefficients of the two forces of friction across a contact, beyond the stiffness of the linear machine, and
/// their derivatives.
struct RubbingHarmonics {
  Eigen::MatrixXd force, by_omega;                             ///< coefficients × 2
  std::array<std::array<Eigen::MatrixXd, 3>, 2> tangent = {};  ///< forces × (deflection along, two across)
};
/// @param course  that of the loop
[[nodiscard]] RubbingHarmonics rubbing_harmonics(const RubbingLoop& loop, const Eigen::MatrixXd& course, double omega,
                                                 bool with_tangent);

/// The two forces at the frequencies μ + k, k = −K … K, by variations e^{i(μ + l)φ} of the deflection along and of the
/// two across.
using RubbingVariation = std::array<std::array<Eigen::MatrixXcd, 3>, 2>;
[[nodiscard]] RubbingVariation rubbing_variation(const RubbingLoop& loop, double omega, double mu,
                                                 Eigen::Index harmonics);

}  // namespace trivet::nonlinear
