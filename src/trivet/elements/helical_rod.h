// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>

#include "trivet/elements/coil_spring.h"

/// The wire of a coil spring as a rod with constant coefficients in the axes of its section: 1 towards the spring's
/// axis, 2 binormal, 3 along the wire. Derivation: docs/elements/coil_spring.md.
namespace trivet::elements {

/// Centre line of the wire. The section axes rotate rigidly about e3 with the angle φ.
struct Helix {
  double radius = 0;       ///< [m]
  double lead = 0;         ///< angle of the section's axis 3 to the plane normal to e3 [rad]
  double turn = 0;         ///< angle travelled from N to K, negative for a left hand [rad]
  double height = 0;       ///< of the active coils [m]
  double start_angle = 0;  ///< [rad]
};
[[nodiscard]] Helix helix(const CoilSpring& spring);

/// Section axes as columns, and position of the section from the axis point at its own height, at angle φ.
[[nodiscard]] Eigen::Matrix3d section_axes(const Helix& helix, double angle);
[[nodiscard]] Eigen::Vector3d from_axis(const Helix& helix, double angle);

/// Constant coefficients of the rod, vectors in section axes, per metre of unstrained wire.
struct HelicalRod {
  double length = 0;                                 ///< unstrained [m]
  Eigen::Vector3d curvature;                         ///< Darboux vector of the section axes [1/m]
  Eigen::Vector3d tangent;                           ///< dr/ds: (0, 0, 1) when stress-free
  Eigen::Vector3d force_flexibility;                 ///< 1/κGA, 1/κGA, 1/EA [1/N]
  Eigen::Vector3d moment_flexibility;                ///< 1/EI₁, 1/EI₂, 1/GJ [1/(N m²)]
  double line_mass = 0;                              ///< ρA [kg/m]
  Eigen::Vector3d line_inertia;                      ///< ρI [kg m]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< internal force of the preload [N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< internal moment of the preload [N m]
};
[[nodiscard]] HelicalRod helical_rod(const CoilSpring& spring);

/// Dynamic stiffness between the ends of the rod, in section axes (u, θ): W_N = own q_N + transfer q_K. A rotation by
/// π about axis 1 of its middle maps the rod onto itself, so W_K = J own J q_K + transferᵀ q_N with J = diag(1, −1, −1,
/// 1, −1, −1).
template <typename Scalar>
struct RodStiffness {
  Eigen::Matrix<Scalar, 6, 6> own;
  Eigen::Matrix<Scalar, 6, 6> transfer;
  int clamped_modes = 0;  ///< natural frequencies below ω with both ends clamped; meaningful for real arguments
};

/// Stiffness at λ = ω² with all moduli multiplied by `modulus` (1 + iη), both finite. Exact: series on a segment, then
/// doubling.
template <typename Scalar>
[[nodiscard]] RodStiffness<Scalar> rod_stiffness(const HelicalRod& rod, Scalar lambda, Scalar modulus);

extern template RodStiffness<double> rod_stiffness(const HelicalRod&, double, double);
extern template RodStiffness<std::complex<double>> rod_stiffness(const HelicalRod&, std::complex<double>,
                                                                 std::complex<double>);
extern template RodStiffness<long double> rod_stiffness(const HelicalRod&, long double, long double);

}  // namespace trivet::elements
