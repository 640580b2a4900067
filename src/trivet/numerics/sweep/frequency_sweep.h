// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/load.h"

namespace trivet::numerics {

/// Backward error above which a frequency is solved anew with pivoting: ‖Zq − h‖∞ / (‖Z‖∞ ‖q‖∞ + ‖h‖∞) in coordinates
/// of unit mass diagonal.
inline constexpr double accepted_backward_error = 1e-14;

/// What depends on ω in its own way.
struct FrequencyPart {
  /// Adds to Z (n × n) and to h (n) at one ω. Called on several threads at once.
  std::function<void(double omega, Eigen::MatrixXcd& Z, Eigen::VectorXcd& h)> add;
  /// Rows of Z that each of its elements couples: it changes Z nowhere else. Empty: it couples all rows.
  std::vector<std::vector<Eigen::Index>> coupled_rows = {};

  explicit operator bool() const { return static_cast<bool>(add); }
};

struct SweepOptions {
  /// Compute the backward error of every solution. Otherwise the growth of the factors bounds it up to six coordinates,
  /// and the residual along one fixed direction shows it beyond: a tenth of the cost.
  bool every_backward_error = true;
  int threads =
      0;  ///< 0: as many as the machine has; one for little work (20,000 solutions of six coordinates, 330 of sixty)
  foundation::Progress progress = {};
};

/// What a sweep had to redo.
struct SweepCounts {
  int fallbacks = 0;  ///< frequencies redone by a pivoted solver
  int singular = 0;   ///< frequencies where Z(ω) is singular

  void add(const SweepCounts& other) {
    fallbacks += other.fallbacks;
    singular += other.singular;
  }
};

/// q(ω) = Z(ω)⁻¹ h(ω) for many ω.
struct SweepResult : SweepCounts {
  Eigen::MatrixXcd response;       ///< n × count; NaN where Z(ω) is singular
  Eigen::VectorXd backward_error;  ///< of each, NaN where Z(ω) is singular; empty unless asked for
};

/// The same by coordinates, for one curve each. Kept by the caller: a second sweep of that size needs no fresh memory,
/// which costs more to touch for the first time than the solutions.
struct SweepPlanes : SweepCounts {
  Eigen::ArrayXXd re, im;         ///< count × n; NaN where Z(ω) is singular
  Eigen::ArrayXd backward_error;  ///< of each; empty unless asked for
};

/// Symmetric matrices: LDLᵀ without pivoting, one frequency per lane; what grows too much or misses
/// `accepted_backward_error` is redone by LU with partial pivoting. Unsymmetric matrices: LU throughout. See
/// docs/decisions/no-pivoting-first.md.
[[nodiscard]] SweepResult sweep(const DynamicMatrices& matrices, const Load& load, const std::vector<double>& omega,
                                const SweepOptions& options = {});

/// With a part that depends on ω in its own way; Z as a whole is symmetric if `matrices.symmetric`.
/// @throws InvalidInput if the part adds to Z where it says that it does not
[[nodiscard]] SweepResult sweep(const DynamicMatrices& matrices, const Load& load, const FrequencyPart& part,
                                const std::vector<double>& omega, const SweepOptions& options = {});

/// Where no backward errors are asked for, many frequencies under a constant load are summed over poles, if these can
/// be proven (pole_sweep.h); otherwise, and where a share of the sums that is put back misses
/// `accepted_backward_error`, solved directly.
void sweep(const DynamicMatrices& matrices, const Load& load, const std::vector<double>& omega, SweepPlanes& result,
           const SweepOptions& options = {});

}  // namespace trivet::numerics
