// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>

#include "trivet/nonlinear/laws/rubbing_loop.h"

namespace trivet::nonlinear {

/// Forces × the three deflections of a contact (RubbingAbout); without any entry: none.
template <typename Entry>
using OfContact = std::array<std::array<Entry, 3>, 3>;

/// Fourier coefficients of the friction on the three deflections of a contact, beyond the stiffness of the linear
/// machine, and their derivatives.
struct RubbingHarmonics {
  Eigen::MatrixXd force, by_omega;  ///< coefficients × 3
  OfContact<Eigen::MatrixXd> tangent = {};
};
/// @param course  that of the loop
[[nodiscard]] RubbingHarmonics rubbing_harmonics(const RubbingLoop& loop, const Eigen::MatrixXd& course, double omega,
                                                 bool with_tangent);

/// The forces at the frequencies μ + k, k = −K … K, by variations e^{i(μ + l)φ} of the deflections.
using RubbingVariation = OfContact<Eigen::MatrixXcd>;
[[nodiscard]] RubbingVariation rubbing_variation(const RubbingLoop& loop, double omega, double mu,
                                                 Eigen::Index harmonics);

}  // namespace trivet::nonlinear
