// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "trivet/elements/viscoelastic.h"
#include "trivet/spatial/types.h"

namespace trivet::elements {

// An elastic element joins two ends N and K. All matrices here are in its local frame, order (u_N, θ_N, u_K, θ_K),
// in N/m, N/rad, N m/m, N m/rad; `arm` is the vector from N to K [m].

using spatial::Matrix12;
using spatial::Matrix6;
using spatial::Vector12;
using spatial::Vector6;
using Matrix12c = Eigen::Matrix<std::complex<double>, 12, 12>;

/// B = factor · K, of the scaled or of the nominal stiffness. factor [s] ≥ 0.
struct ProportionalDamping {
  double factor = 0;
  bool of_nominal = false;
};
/// K(1 + iη). η ≥ 0, of the scaled stiffness.
struct LossFactor {
  double value = 0;
};
/// An explicit 12×12 viscous damping matrix [N s/m …]; the stiffness scale does not change it.
struct DampingMatrix {
  Matrix12 matrix = Matrix12::Zero();
};
using Damping = std::variant<std::monostate, ProportionalDamping, LossFactor, DampingMatrix, Viscoelastic>;

/// Mass of the element itself: that of its static shapes, and its internal modes with both ends held (modal masses 1).
struct Inertia {
  Matrix12 mass = Matrix12::Zero();     ///< [kg …]
  Eigen::MatrixXd coupling{12, 0};      ///< 12 × modes: mass between end displacements and internal modes
  Eigen::VectorXd angular_frequencies;  ///< of the internal modes at nominal stiffness [rad/s]
};

/// A dynamic stiffness D(ω) [N/m …] that is not a rational function: exact continua and measured tables. For complex ω,
/// Re ω ≥ 0; a table uses the interpolation piece at the real frequency `near`.
struct FrequencyDependence {
  std::function<Matrix12c(std::complex<double> omega, double near)> stiffness;
  bool elastic = true;  ///< without own losses: damping then enters as a complex modulus μ, D = μ D(ω/√μ)
  double from = 0, to = std::numeric_limits<double>::infinity();  ///< range of definition [rad/s]
  std::vector<double> knots;  ///< boundaries between the pieces of a table [rad/s], ascending
};

/// Coordinates of parts inside the element, such as columns of fluid, with the forces and masses that they add.
struct InnerParts {
  std::vector<std::string> names;            ///< one per coordinate
  Eigen::MatrixXd stiffness, damping, mass;  ///< (12 + coordinates)², neither scaled nor damped by `damping`
  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(names.size()); }
};

/// The nonlinear parts of an element about its position of rest: tangent · u + damping · u̇ + offset on its ends, and
/// one of each on every inner coordinate.
struct Linearization {
  Matrix12 tangent = Matrix12::Zero();
  Matrix12 damping = Matrix12::Zero();
  Vector12 offset = Vector12::Zero();
  Eigen::VectorXd inner_tangent, inner_damping, inner_offset;
};

/// Law of an element: nominal stiffness (at ω = 0), scale factor, damping, own mass, and static preload.
struct Law {
  Matrix12 nominal_stiffness = Matrix12::Zero();
  double scale = 1;
  Damping damping;
  std::optional<Inertia> inertia;
  std::optional<InnerParts> inner;
  std::optional<FrequencyDependence> frequency_dependence;
  std::optional<Linearization> nonlinear;  ///< neither scaled nor damped
  std::optional<Vector12> preload;         ///< forces and moments on the ends N, K in the state about which it vibrates
  /// Of a straight slender element along e3: what a tension at rest adds to the stiffness, per newton [1/m …].
  std::optional<Matrix12> per_tension;
};

/// Stiffness at ω = 0, scaled, with the tangent of the nonlinear parts.
[[nodiscard]] Matrix12 stiffness(const Law& law);
/// What the inner parts add to the 12×12 at a frequency: their coordinates are free of other forces.
[[nodiscard]] Matrix12c stiffness_of_inner_parts(const Law& law, std::complex<double> omega);
/// Viscous damping matrix at the ends, with that of the nonlinear parts.
[[nodiscard]] Matrix12 viscous_damping(const Law& law);
[[nodiscard]] double loss_factor(const Law& law);

/// Is D(ω) more than `matrices` can represent exactly?
[[nodiscard]] bool is_frequency_dependent(const Law& law);

/// The element as a linear system in 12 end displacements and its internal coordinates (modes of its mass, strains of
/// Maxwell branches without mass, then the inner parts): K(1 + iη), B, M. Exact unless `is_frequency_dependent`; then
/// an approximation for modes and starting values.
struct Matrices {
  Eigen::MatrixXd stiffness, damping, mass;
  Eigen::MatrixXd
      loss;  ///< imaginary part of the stiffness: η times that of the linear law, without laws and inner parts
  double loss_factor = 0;  ///< η
};
[[nodiscard]] Matrices matrices(const Law& law);

/// Dynamic stiffness D(ω), 12×12, internal coordinates condensed. omega [rad/s] may be complex, Re ω ≥ 0.
/// @throws foundation::NotComputable outside the range of a tabulated law
[[nodiscard]] Matrix12c dynamic_stiffness(const Law& law, std::complex<double> omega, double near);
[[nodiscard]] inline Matrix12c dynamic_stiffness(const Law& law, double omega) {
  return dynamic_stiffness(law, omega, omega);
}

/// The 12×12 that follows by equilibrium from a 6×6 block of the K end (N fixed): E C_KK Eᵀ, with no energy in a rigid
/// motion.
[[nodiscard]] Matrix12 from_moved_end(const Matrix6& moved_end, const Eigen::Vector3d& arm);

/// Three translational [N/m] and three rotational [N m/rad] constants acting between the ends at the point at the
/// fraction `centre` of the arm from N (0 = N, 1 = K), both ends rigidly attached to it.
[[nodiscard]] Matrix12 constants_at_point(const Vector6& constants, const Eigen::Vector3d& arm, double centre);

/// One constant along the unit vector `axis`, through the same point.
[[nodiscard]] Matrix12 constant_along_line(double constant, const Eigen::Vector3d& axis, const Eigen::Vector3d& arm,
                                           double centre);

/// The deflection along or about one axis (0 … 2 translations, 3 … 5 rotations of K relative to N, axes of K) at the
/// same point, as a row on the 12 end displacements.
[[nodiscard]] Eigen::Matrix<double, 1, 12> deflection_row(int axis, const Eigen::Vector3d& arm,
                                                          const Eigen::Matrix3d& n_from_k, double centre);

/// Translations of end K less those of end N, axes of K, on the 12 end displacements.
[[nodiscard]] Eigen::Matrix<double, 3, 12> difference_rows(const Eigen::Matrix3d& n_from_k);

/// The same element with separate axes for N: rows and columns of N rotated by `n_from_k`.
[[nodiscard]] Matrix12 in_end_axes(const Matrix12& in_axes_of_k, const Eigen::Matrix3d& n_from_k);

/// Rigid motions of the two ends, 12×6: motion of K in the axes of K, and the same motion of N in the axes of N;
/// `n_from_k` transforms components from K's axes to N's.
[[nodiscard]] Eigen::Matrix<double, 12, 6> rigid_motions(const Eigen::Vector3d& arm, const Eigen::Matrix3d& n_from_k);

}  // namespace trivet::elements
