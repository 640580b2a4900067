// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <functional>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/load.h"

namespace trivet::numerics {

/// Backward error above which a frequency is solved again with pivoting: ‖Zq − h‖∞ / (‖Z‖∞ ‖q‖∞ + ‖h‖∞) in coordinates
/// of unit mass diagonal.
inline constexpr double accepted_backward_error = 1e-14;

/// Frequency-dependent part of Z and h.
struct FrequencyPart {
  /// Adds to Z (n × n) and to h (n) at one ω. Called on several threads at once.
  std::function<void(double omega, Eigen::MatrixXcd& Z, Eigen::VectorXcd& h)> add;
  /// Rows of Z coupled by each of its elements; it changes Z nowhere else. Empty: it couples all rows.
  std::vector<std::vector<Eigen::Index>> coupled_rows = {};

  explicit operator bool() const { return static_cast<bool>(add); }
};

struct SweepOptions {
  /// Compute the backward error of every solution. Otherwise it is bounded by the growth of the factors up to six
  /// coordinates, and estimated by the residual along one fixed direction beyond: a tenth of the cost.
  bool every_backward_error = true;
  int threads = 0;  ///< 0: as many as the machine has; one for little work (below 20,000 solutions of six coordinates,
                    ///< 330 of sixty)
  foundation::Progress progress = {};
};

/// Numbers of frequencies that were recomputed, and that are singular.
struct SweepCounts {
  int fallbacks = 0;  ///< frequencies recomputed by a pivoted solver
  int singular = 0;   ///< frequencies with singular Z(ω)

  void add(const SweepCounts& other) {
    fallbacks += other.fallbacks;
    singular += other.singular;
  }
};

/// q(ω) = Z(ω)⁻¹ h(ω) for many ω.
struct SweepResult : SweepCounts {
  Eigen::MatrixXcd response;       ///< n × count; NaN if Z(ω) is singular
  Eigen::VectorXd backward_error;  ///< of each frequency, NaN if Z(ω) is singular; empty unless requested
};

/// Response at all ω. Symmetric matrices: LDLᵀ without pivoting, one frequency per lane; frequencies with too much
/// growth or an error above `accepted_backward_error` are recomputed by LU with partial pivoting. Unsymmetric matrices:
/// always LU. See docs/decisions/no-pivoting-first.md.
[[nodiscard]] SweepResult sweep(const DynamicMatrices& matrices, const Load& load, const std::vector<double>& omega,
                                const SweepOptions& options = {});

/// With a frequency-dependent part; Z as a whole is symmetric if `matrices.symmetric`.
/// @throws InvalidInput if the part adds to Z outside its coupled rows
[[nodiscard]] SweepResult sweep(const DynamicMatrices& matrices, const Load& load, const FrequencyPart& part,
                                const std::vector<double>& omega, const SweepOptions& options = {});

}  // namespace trivet::numerics
