// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/nonlinear/laws/distance_laws.h"
#include "trivet/nonlinear/laws/law_harmonics.h"

namespace trivet::nonlinear {

/// Share of the period in which a stop of the law is touched, 0 … 1.
/// @param deflection  Fourier coefficients of the deviation from rest
/// @param omega       of the first harmonic [rad/s]
[[nodiscard]] double contact_share(const LawHarmonics& law, const Eigen::VectorXd& deflection, double omega);
/// The same of a ring. @param course  coefficients × 3
[[nodiscard]] double contact_share(const DistanceHarmonics& law, const Eigen::MatrixXd& course);

}  // namespace trivet::nonlinear
