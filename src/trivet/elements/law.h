// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>

#include "trivet/spatial/types.h"

/// An elastic element joins two ends N and K. All matrices here are in its local frame, order (u_N, θ_N, u_K, θ_K),
/// in N/m, N/rad, N m/m, N m/rad; `arm` is the vector from N to K [m].
namespace trivet::elements {

using spatial::Matrix12;
using spatial::Matrix6;
using spatial::Vector6;

/// B = factor · K, of the scaled or of the nominal stiffness. factor [s] ≥ 0.
struct ProportionalDamping {
  double factor = 0;
  bool of_nominal = false;
};
/// K(1 + iη). η ≥ 0, of the scaled stiffness.
struct LossFactor {
  double value = 0;
};
/// An explicit 12×12 viscous damping matrix [N s/m …]; the stiffness scale leaves it alone.
struct DampingMatrix {
  Matrix12 matrix = Matrix12::Zero();
};
using Damping = std::variant<std::monostate, ProportionalDamping, LossFactor, DampingMatrix>;

/// What an element does: nominal stiffness, the factor on it, and its damping.
struct Law {
  Matrix12 nominal_stiffness = Matrix12::Zero();
  double scale = 1;
  Damping damping;
};

[[nodiscard]] Matrix12 stiffness(const Law& law);
[[nodiscard]] Matrix12 viscous_damping(const Law& law);
[[nodiscard]] double loss_factor(const Law& law);

/// The 12×12 that a 6×6 block of the K end (N fixed) implies by equilibrium: E C_KK Eᵀ, storing no energy in a rigid motion.
[[nodiscard]] Matrix12 from_moved_end(const Matrix6& moved_end, const Eigen::Vector3d& arm);

/// Three translational [N/m] and three rotational [N m/rad] constants acting between the ends at the point that lies the
/// fraction `centre` of the arm from N (0 = N, 1 = K), both ends joined to it by rigid levers.
[[nodiscard]] Matrix12 constants_at_point(const Vector6& constants, const Eigen::Vector3d& arm, double centre);

/// One constant along the unit vector `axis`, through the same point.
[[nodiscard]] Matrix12 constant_along_line(double constant, const Eigen::Vector3d& axis, const Eigen::Vector3d& arm, double centre);

/// The same element seen in N axes of its own: rows and columns of N turned by `n_from_k`.
[[nodiscard]] Matrix12 in_end_axes(const Matrix12& in_axes_of_k, const Eigen::Matrix3d& n_from_k);

/// Rigid motions of the two ends, 12×6: motion of K in the axes of K, and what N does with it in the axes of N, where
/// `n_from_k` turns components in K's axes into N's.
[[nodiscard]] Eigen::Matrix<double, 12, 6> rigid_motions(const Eigen::Vector3d& arm, const Eigen::Matrix3d& n_from_k);

}  // namespace trivet::elements
