// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/nonlinear/observed_motion.h"
#include "trivet/nonlinear/periodic_stability.h"
#include "trivet/nonlinear/reference_machine.h"
#include "trivet/nonlinear/steady_branch.h"
#include "trivet/nonlinear/steady_path.h"
#include "trivet/nonlinear/winding_stability.h"

namespace trivet::nonlinear {

/// Results and stability of the motions on a path.
class ObservedPath {
 public:
  /// All must outlive it.
  /// @param all  paths of motions with the same period, this one among them: where a jump lands
  ObservedPath(const ReferenceMachine& machine, const SteadyPath& path, std::vector<const SteadyPath*> all,
               const SteadyOptions& options);

  [[nodiscard]] SteadyBranch branch(const foundation::Progress& progress);

 private:
  [[nodiscard]] SteadyPoint steady(const numerics::BranchPoint& point) const;
  [[nodiscard]] double contact(std::size_t stop, const SteadyPoint& point) const;
  void judge_by_winding(SteadyBranch& found, const foundation::Progress& progress);
  void judge(const std::vector<std::size_t>& chosen, SteadyBranch& found, const foundation::Progress& progress) const;
  [[nodiscard]] std::optional<SteadyPoint> landing(const numerics::BranchPoint& fold) const;
  void note_sticking(const numerics::BranchPoint& point, SteadyBranch& found) const;
  void add_changes(SteadyBranch& found) const;
  [[nodiscard]] StabilityChange change_after(std::size_t point) const;

  const ReferenceMachine& machine_;
  const SteadyPath& path_;
  std::vector<const SteadyPath*> all_;
  const SteadyOptions& options_;
  std::vector<std::size_t> stops_;  ///< deflections that have any
  Observer observer_;
  PeriodicStability stability_;
  WindingStability winding_;
  bool by_winding_ = false;  ///< the winding number decides, because the multipliers of constant matrices differ
};

}  // namespace trivet::nonlinear
