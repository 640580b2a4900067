// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/nonlinear/balance/observed_motion.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/nonlinear/branch/steady_path.h"
#include "trivet/nonlinear/machine/reference_machine.h"
#include "trivet/nonlinear/stability/periodic_stability.h"

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

  /// Motion of all places at each harmonic, from the mean on.
  [[nodiscard]] std::vector<response::DeflectionShape> shapes(const HarmonicBalance& balance,
                                                              const Eigen::VectorXd& unknowns,
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

/// Results and stability of the motions on a path.
class ObservedPath {
 public:
  /// All must outlive it.
  /// @param path  points are added to it where its stability may change between two
  ObservedPath(const ReferenceMachine& machine, SteadyPath& path, const SteadyOptions& options);

  /// Without the motions on which jumps land.
  [[nodiscard]] SteadyBranch branch(const foundation::Progress& progress);
  /// All known motions at a parameter, in the unknowns of this path.
  using MotionsAt = std::function<std::vector<numerics::BranchPoint>(double parameter)>;
  /// Adds those of a branch.
  void add_landings(const MotionsAt& known, SteadyBranch& branch) const;

 private:
  [[nodiscard]] SteadyPoint steady(const numerics::BranchPoint& point) const;
  void add_points_between(SteadyBranch& found);
  [[nodiscard]] bool may_be_unstable_between(const SteadyBranch& found, std::size_t step) const;
  void judge_by_winding(SteadyBranch& found, const foundation::Progress& progress);
  void judge(const std::vector<std::size_t>& chosen, SteadyBranch& found, const foundation::Progress& progress) const;
  [[nodiscard]] bool contradicts(const numerics::BranchPoint& point, SteadyPoint& judged) const;
  [[nodiscard]] std::vector<SteadyPoint> landings(const MotionsAt& known, const numerics::BranchPoint& fold) const;
  void note_sticking(const numerics::BranchPoint& point, SteadyBranch& found) const;
  void add_changes(SteadyBranch& found) const;
  [[nodiscard]] StabilityChange change_after(std::size_t point, bool by_number) const;

  const ReferenceMachine& machine_;
  SteadyPath& path_;
  const SteadyOptions& options_;
  PointObserver observer_;
  bool by_winding_ = false;  ///< the winding number decides, because the multipliers of constant matrices differ
};

}  // namespace trivet::nonlinear
