// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Solution plan for the frequencies of one system, prepared once; sweep_workspace.h executes it.
#include <optional>

#include "trivet/foundation/index.h"
// Solves the frequencies of one system, chunk by chunk.
#include "trivet/numerics/lanes/line_memory.h"
#include "trivet/numerics/sweep/block_sweep.h"
#include "trivet/numerics/sweep/frequency_sweep.h"
#include "trivet/numerics/sweep/sweep_kernels.h"

namespace trivet::numerics {

enum class SweepSolver {
  aimed,         ///< n ≤ 6, the load a real direction times a factor: unrolled loops, no forward substitution
  fixed,         ///< n ≤ 6, any load: unrolled loops
  blocks,        ///< n > 6, or a frequency-dependent part: by bodies, blocks without coupling are skipped
  pivoted,       ///< unsymmetric
  one_frequency  ///< unsymmetric, many coordinates with a frequency-dependent part: one frequency at a time, to save
                 ///< memory
};

/// One system in coordinates of unit mass diagonal. Selects the solver of a sweep.
class SweepPlan {
 public:
  SweepPlan(const DynamicMatrices& matrices, const Load& load, FrequencyPart part = {});

  [[nodiscard]] SweepSolver solver() const { return solver_; }
  [[nodiscard]] int size() const { return static_cast<int>(scale_.size()); }
  /// Time of one solution relative to one of six coordinates, to an order of magnitude: a body among many takes five
  /// times as long as a single one, element laws take longer.
  [[nodiscard]] std::size_t weight() const { return (size() > 6 ? to_size(size()) : 1) * (part_ ? 20U : 1U); }

 private:
  friend class SweepWorkspace;
  void choose_solver();
  void aim(const LoadTerm& term, Eigen::Index last);
  void use_blocks(const DynamicMatrices& given, const Load& given_load);
  [[nodiscard]] bool evaluates_part_per_frequency() const {
    return part_ && (solver_ == SweepSolver::blocks || solver_ == SweepSolver::one_frequency);
  }

  Eigen::VectorXd scale_;
  DynamicMatrices matrices_;  ///< empty if `blocks_` contains them
  Load load_;
  FrequencyPart part_;
  SweepSolver solver_ = SweepSolver::pivoted;
  std::optional<sweep_kernels::Coefficients>
      solved_;  ///< input of the solver, in the coordinates of `aim_` if it is aimed
  sweep_kernels::Aim aim_;
  std::optional<BlockSweep> blocks_;
  std::vector<FreeEntry> free_;  ///< for blocks: entries that the part may change
};

/// Memory for one chunk of frequencies on one thread, and its solutions.
class SweepWorkspace {
 public:
  static constexpr long chunk = 256;  ///< frequencies; with six coordinates they stay in the nearest cache

  explicit SweepWorkspace(const SweepPlan& plan);

  /// Solutions at `count` ≤ `chunk` frequencies, valid until the next call.
  Planes solve(const double* omega, long count, bool every_backward_error);

  [[nodiscard]] const double* backward_errors() const { return error_.data(); }
  [[nodiscard]] const SweepCounts& counts() const { return counts_; }

 private:
  /// Planes of a chunk: real parts first, then imaginary parts.
  static Planes planes_in(const LineMemory& memory) {
    return {memory.data(), memory.data() + memory.size() / 2, chunk};
  }

  void fill_load(long count, bool all);
  void fill_parts(long count);
  void fill_free(long first, long count);
  void solve_blocks(long padded, bool every_backward_error);
  void recompute_rejected(std::vector<char> marked, long count);
  void recompute(const std::vector<char>& marked);
  void recompute_one(long f);
  [[nodiscard]] Eigen::VectorXcd load_at(long f) const;

  const SweepPlan* plan_;
  /// Coefficients in plain coordinates; an aimed system needs them only for residuals and pivoting.
  const sweep_kernels::Coefficients& plain();

  std::optional<sweep_kernels::Coefficients> plain_;
  LineMemory omega_, load_, amplitude_, part_, q_, error_, blocks_;
  Eigen::MatrixXcd z_part_;  ///< 0, except for entries that a part adds outside its coupled rows
  int load_filled_ = 0;      ///< 1: for the solver; 2: also for residuals
  bool load_finite_ = true;
  SweepCounts counts_;
};

}  // namespace trivet::numerics
