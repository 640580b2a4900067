// SPDX-License-Identifier: BSD-3-Clause
// How the frequencies of one system are solved, prepared once. See sweep_workspace.h for the solving.
#pragma once

#include <optional>

#include "trivet/numerics/sweep/block_sweep.h"
#include "trivet/numerics/sweep/frequency_sweep.h"
#include "trivet/numerics/sweep/sweep_kernels.h"

namespace trivet::numerics {

enum class SweepSolver {
  aimed,    ///< n ≤ 6, the load a real direction times a factor: loops written out, no forward substitution
  fixed,    ///< n ≤ 6, any load: loops written out
  blocks,   ///< n > 6, or a part that depends on ω: by bodies, skipping what does not couple
  pivoted,  ///< unsymmetric
  alone     ///< unsymmetric, many coordinates with a part that depends on ω: one frequency at a time, for the sake of
            ///< memory
};

/// One system in coordinates of unit mass diagonal. Every solver for a sweep is chosen here.
class SweepPlan {
 public:
  SweepPlan(const DynamicMatrices& matrices, const Load& load, FrequencyPart part = {});

  [[nodiscard]] SweepSolver solver() const { return solver_; }
  [[nodiscard]] int size() const { return static_cast<int>(scale_.size()); }
  /// One solution beside one of six coordinates in time, to an order of magnitude: a body of many takes five times as
  /// long as one alone, laws of elements longer.
  [[nodiscard]] std::size_t weight() const {
    return (size() > 6 ? static_cast<std::size_t>(size()) : 1) * (part_ ? 20U : 1U);
  }

 private:
  friend class SweepWorkspace;
  void choose_solver();
  void aim(const LoadTerm& term, Eigen::Index last);
  void use_blocks(const DynamicMatrices& given, const Load& given_load);
  [[nodiscard]] bool evaluates_part_alone() const {
    return part_ && (solver_ == SweepSolver::blocks || solver_ == SweepSolver::alone);
  }

  Eigen::VectorXd scale_;
  DynamicMatrices matrices_;  ///< empty where blocks hold them
  Load load_;
  FrequencyPart part_;
  SweepSolver solver_ = SweepSolver::pivoted;
  std::optional<sweep_kernels::Coefficients>
      solved_;  ///< what `solver` reads, in the coordinates of `aim_` if it is aimed
  sweep_kernels::Aim aim_;
  std::optional<BlockSweep> blocks_;
  std::vector<FreeEntry> free_;  ///< of the blocks: what the part may change
};

/// Threads for so many solutions of six coordinates: one where another would start later than it ends.
[[nodiscard]] inline int sweep_threads(std::size_t solutions, int wanted) { return solutions < 20000 ? 1 : wanted; }

}  // namespace trivet::numerics
