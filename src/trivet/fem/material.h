// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/foundation/problems.h"

namespace trivet::fem {

/// Pressure of a tetrahedron: constant and condensed (most stiffnesses converge from below on graded meshes), or linear
/// and continuous (from above). Hexahedra always have their own linear pressure, condensed.
enum class TetPressure { constant, continuous };

/// Hyperelastic solid W = C10 (Ī1−3) + C01 (Ī2−3) + C20 (Ī1−3)² + C30 (Ī1−3)³ + κ/2 (J−1)² with the isochoric
/// invariants Ī1 = J^(−2/3) tr C, Ī2 = J^(−4/3) (tr²C − tr C²)/2. At small strain: shear modulus G = 2 (C10 + C01),
/// bulk modulus κ. All in Pa.
struct Material {
  double c10 = 0, c01 = 0, c20 = 0, c30 = 0;
  double bulk_modulus = 0;
};

/// Young's modulus E [Pa] > 0 and Poisson's ratio −1 < ν < 0.5; at large strain a neo-Hookean solid.
/// @throws InvalidInput outside this range; the message explains how to describe an incompressible rubber
[[nodiscard]] Material linear_elastic(double young_modulus, double poisson_ratio);
/// Shear and bulk modulus [Pa], both > 0.
[[nodiscard]] Material neo_hookean(double shear_modulus, double bulk_modulus);
[[nodiscard]] Material mooney_rivlin(double c10, double c01, double bulk_modulus);
[[nodiscard]] Material yeoh(double c10, double c20, double c30, double bulk_modulus);

[[nodiscard]] inline double shear_modulus(const Material& material) { return 2 * (material.c10 + material.c01); }
[[nodiscard]] double poisson_ratio(const Material& material);

/// Checks the constants: finite numbers, G > 0, κ > 0, Poisson's ratio in (−1, 0.5) and not so close to 0.5 that double
/// precision is lost (κ/G ≤ 1e8).
[[nodiscard]] foundation::Problems check(const Material& material);

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
