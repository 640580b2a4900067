// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "trivet/numerics/peaks/disc_search.h"

namespace trivet::numerics {

/// A maximum after Newton steps on d|y|²/dω in extended precision.
struct RefinedPeak {
  double angular_frequency = 0;  ///< [rad/s]
  double amplitude = 0;
  double frequency_uncertainty = 0;  ///< [rad/s]; effect of one unit of round-off in A, B, K (first order)
  double amplitude_uncertainty = 0;  ///< the same for the amplitude
  bool converged = false;
};

/// Refines the peaks of one system.
class PeakRefinement {
 public:
  explicit PeakRefinement(const DrivenSystem& system);

  /// Refined maximum near `omega`. Stops with converged = false and the values of the last step if a step leaves
  /// [omega − reach, omega + reach].
  [[nodiscard]] RefinedPeak refined(const ObservedCurve& curve, double omega, double reach) const;

 private:
  struct Scaled;
  std::shared_ptr<const Scaled> scaled_;
};

}  // namespace trivet::numerics
