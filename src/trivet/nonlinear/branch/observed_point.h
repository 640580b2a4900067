// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/nonlinear/balance/observed_motion.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/nonlinear/machine/reference_machine.h"
#include "trivet/nonlinear/stability/periodic_stability.h"
#include "trivet/nonlinear/stability/winding_stability.h"

namespace trivet::nonlinear {

/// Results and stability of single motions.
class PointObserver {
 public:
  /// Both must outlive it.
  PointObserver(const ReferenceMachine& machine, const SteadyOptions& options);

  /// Names and units of what it observes.
  void describe(SteadyBranch& branch) const;
  /// Stable by the multipliers, and by folds over the amplitude. Where the multipliers do not hold, the second verdict
  /// decides; without it the stability is uncertain.
  [[nodiscard]] SteadyPoint at(const HarmonicBalance& balance, const Eigen::VectorXd& unknowns,
                               const Driving& driving) const;

  [[nodiscard]] const PeriodicStability& stability() const { return stability_; }
  [[nodiscard]] const WindingStability& winding() const { return winding_; }
  /// Is there a second verdict? Not with loss factors, and not if forces depend on the amplitude.
  [[nodiscard]] bool has_winding() const;

 private:
  [[nodiscard]] double contact(std::size_t stop, const HarmonicBalance& balance, const SteadyPoint& point) const;

  const ReferenceMachine& machine_;
  const SteadyOptions& options_;
  std::vector<std::size_t> stops_;  ///< deflections that have any
  bool of_amplitude_ = false;       ///< forces depend on it
  Observer observer_;
  PeriodicStability stability_;
  WindingStability winding_;
};

}  // namespace trivet::nonlinear
