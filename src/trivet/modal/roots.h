// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <vector>

#include "trivet/modal/modes.h"

namespace trivet::modal {

enum class RootKind { oscillating, overdamped, growing, rigid };

/// One solution of λ²A + λB + K(1 + iη), or of the exact Z(−iλ) where elements depend on ω in their own way; motion
/// Re(v e^{λt}).
struct Root {
  std::complex<double> eigenvalue;  ///< λ [1/s]
  RootKind kind = RootKind::oscillating;
  std::optional<double> angular_frequency;         ///< |λ| [rad/s], only where it oscillates
  std::optional<double> damped_angular_frequency;  ///< |Im λ| [rad/s]
  std::optional<double> damping_ratio;             ///< −Re λ/|λ|
  Eigen::VectorXcd shape;                          ///< six per body at the poles, largest (mass-weighted) component 1
  /// Number of the undamped mode that the shape has most of: more than half of the mass-weighted square that all modes
  /// have of it. Where damping couples modes so that none has, the mode nearest in |λ|.
  std::optional<int> nearest_mode;
  bool exact = true;  ///< false: of the nearest linear system, where elements depend on ω in their own way
};

struct Roots {
  std::vector<Root> list;  ///< ascending |λ|; all 2n, or those with Im λ > 0 where loss factors enter
  Eigen::VectorXcd poles;  ///< every λ, also those that `list` leaves out: the poles of any response at iω = λ
  foundation::Problems warnings;
  foundation::Problems remarks;  ///< of the roots alone, not of the model
};

/// Damped roots. They do not pair with the modes; `nearest_mode` is a hint for reading.
[[nodiscard]] Roots roots(const model::System& system, const assembly::Assembled& assembled, const Modes& modes);
[[nodiscard]] Roots roots(const model::System& system);

[[nodiscard]] const char* name(RootKind kind);

}  // namespace trivet::modal
