// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/fem/material.h"

namespace trivet::fem {

using Matrix9 = Eigen::Matrix<double, 9, 9>;

/// First and second derivative, by the deformation gradient F, of the isochoric energy plus p (J − 1). Entry (i, I) of
/// F is number i + 3 I, Eigen's storage order.
struct StressAndTangent {
  Eigen::Matrix3d stress;  ///< first Piola–Kirchhoff stress [Pa]
  Matrix9 tangent;         ///< [Pa]
};
[[nodiscard]] StressAndTangent stress_and_tangent(const Material& material, const Eigen::Matrix3d& deformation_gradient,
                                                  double pressure);

/// Cofactor of F = ∂ det F / ∂F.
[[nodiscard]] Eigen::Matrix3d cofactor(const Eigen::Matrix3d& f);

}  // namespace trivet::fem
