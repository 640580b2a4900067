// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <complex>
#include <optional>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/modal/modes.h"

namespace trivet::modal {

enum class RootKind { oscillating, overdamped, growing, rigid };

/// One solution of λ²A + λB + K(1 + iη), or of the exact Z(−iλ) with frequency-dependent elements; motion Re(v e^{λt}).
struct Root {
  std::complex<double> eigenvalue;  ///< λ [1/s]
  RootKind kind = RootKind::oscillating;
  std::optional<double> angular_frequency;         ///< |λ| [rad/s], only if it oscillates
  std::optional<double> damped_angular_frequency;  ///< |Im λ| [rad/s]
  std::optional<double> damping_ratio;             ///< −Re λ/|λ|
  Eigen::VectorXcd shape;                          ///< six per body at the poles, largest (mass-weighted) component 1
  /// Motion of the ends N of elements on flexible foundations (`elements_on_foundations`), scaled as `shape`: 6 ×
  /// elements, ground axes.
  Eigen::Matrix<std::complex<double>, 6, Eigen::Dynamic> feet;
  /// Number of the undamped mode that contributes more than half of the shape's mass-weighted norm squared, summed over
  /// the modes. If damping couples the modes so that none does, the mode nearest in |λ|. Empty for a relaxation inside
  /// elements, which moves no mass.
  std::optional<int> nearest_mode;
  bool exact = true;  ///< false: root of the nearest linear system of frequency-dependent elements
};

struct Roots {
  std::vector<Root> list;  ///< ascending |λ|; all 2n, or those with Im λ > 0 if there are loss factors
  Eigen::VectorXcd poles;  ///< every λ, also those not in `list`: the poles of any response at iω = λ
  foundation::Problems warnings;
  foundation::Problems remarks;  ///< on the roots alone, not on the model
};

/// Damped roots. They do not correspond one to one to the modes; `nearest_mode` is only a hint.
[[nodiscard]] Roots roots(const model::System& system, const assembly::Assembled& assembled, const Modes& modes);
[[nodiscard]] Roots roots(const model::System& system);

/// True if no free vibration can grow, whatever the roots: constant matrices, A positive definite, K, B and the loss
/// positive semidefinite. False does not mean that one grows.
[[nodiscard]] bool cannot_grow(const assembly::Assembled& assembled, const Modes& modes);

[[nodiscard]] const char* name(RootKind kind);

/// A root of the exact Z: Z(−iλ) v = 0.
struct ExactRoot {
  std::complex<double> eigenvalue;
  Eigen::VectorXcd shape;  ///< first rows of the layout
  bool converged = false;
};

/// Inverse iteration with Newton steps on λ from a root of the nearest linear system, for frequency-dependent elements.
/// Im λ > 0.
[[nodiscard]] ExactRoot exact_root(const assembly::Assembled& assembled, std::complex<double> start,
                                   const Eigen::VectorXcd& shape);

/// dZ/dλ of the exact Z(−iλ), to about ten digits.
[[nodiscard]] Eigen::MatrixXcd stiffness_slope(const assembly::Assembled& assembled, std::complex<double> lambda);

}  // namespace trivet::modal
