// SPDX-License-Identifier: BSD-3-Clause
// How the frequencies of one system are solved: prepared once, then chunk by chunk.
#pragma once

#include <optional>

#include "trivet/numerics/block_sweep.h"
#include "trivet/numerics/frequency_sweep.h"
#include "trivet/numerics/sweep_kernels.h"

namespace trivet::numerics {

enum class SweepSolver {
  aimed,    ///< n ≤ 6, the load a real direction times a factor: loops written out, no forward substitution
  fixed,    ///< n ≤ 6, any load: loops written out
  blocks,   ///< n > 6, or a part that depends on ω: by bodies, skipping what does not couple
  pivoted,  ///< unsymmetric
  alone     ///< unsymmetric, many coordinates with a part that depends on ω: one frequency at a time, for the sake of memory
};

/// One system in coordinates of unit mass diagonal. Every solver for a sweep is chosen here.
class SweepPlan {
 public:
  SweepPlan(const DynamicMatrices& matrices, const Load& load, FrequencyPart part = {});

  [[nodiscard]] SweepSolver solver() const { return solver_; }
  [[nodiscard]] int size() const { return static_cast<int>(scale_.size()); }

 private:
  friend class SweepWorkspace;
  void choose_solver();
  void aim(const LoadTerm& term, Eigen::Index last);
  void use_blocks(const DynamicMatrices& given, const Load& given_load);
  [[nodiscard]] bool evaluates_part_alone() const { return part_ && (solver_ == SweepSolver::blocks || solver_ == SweepSolver::alone); }

  Eigen::VectorXd scale_;
  DynamicMatrices matrices_;  ///< empty where blocks hold them
  Load load_;
  FrequencyPart part_;
  SweepSolver solver_ = SweepSolver::pivoted;
  std::optional<sweep_kernels::Coefficients> solved_;  ///< what `solver` reads, in the coordinates of `aim_` if it is aimed
  sweep_kernels::Aim aim_;
  std::optional<BlockSweep> blocks_;
  std::vector<FreeEntry> free_;  ///< of the blocks: what the part may change
};

/// Threads for so many solutions: one where another would start later than it ends.
[[nodiscard]] inline int sweep_threads(std::size_t solutions, int wanted) { return solutions < 20000 ? 1 : wanted; }

/// Memory for one chunk of frequencies on one thread, and its solutions.
class SweepWorkspace {
 public:
  static constexpr long chunk = 256;  ///< frequencies: six coordinates of them stay in the nearest cache

  SweepWorkspace() = default;
  explicit SweepWorkspace(const SweepPlan& plan) { take(plan); }

  /// Solves another system from now on, in the same memory where it has the same size. The counts go on.
  void take(const SweepPlan& plan);

  /// Solutions at `count` ≤ `chunk` frequencies, into `target` or, if that is null or the chunk is not full, into planes of its own.
  /// @return where they are
  Planes solve(const double* omega, long count, bool every_backward_error, Planes target = {});

  /// Raises the largest |q_j|² by those of the last chunk and tells where they are.
  void raise_maxima(const Planes& q, double* square, double* angular_frequency) const {
    sweep_kernels::raise_maxima(plan_->size(), {omega_.data(), padded_, {}, {}, nullptr, q, nullptr}, square, angular_frequency);
  }
  [[nodiscard]] const double* backward_errors() const { return error_.data(); }
  [[nodiscard]] const SweepCounts& counts() const { return counts_; }

 private:
  void fill_load(long count, bool all);
  void fill_parts(long count);
  void fill_free(long first, long count);
  void solve_blocks(bool every_backward_error, const Planes& q);
  void redo_missed(std::vector<char> marked, long count, const Planes& q);
  void redo(const std::vector<char>& marked, const Planes& q);
  void redo_alone(long f, const Planes& q);
  [[nodiscard]] Eigen::VectorXcd load_at(long f) const;

  const SweepPlan* plan_ = nullptr;
  /// Of the system in plain coordinates: of an aimed one only residuals and pivoting need them.
  const sweep_kernels::Coefficients& plain();

  std::optional<sweep_kernels::Coefficients> plain_;
  LineMemory omega_, load_, amplitude_, part_, q_, error_, blocks_;
  Eigen::MatrixXcd z_part_;  ///< 0, but for what a part adds beside its rows
  long padded_ = 0;
  int load_filled_ = 0;  ///< 1: what the solver reads; 2: what residuals read, too
  bool load_finite_ = true;
  SweepCounts counts_;
};

}  // namespace trivet::numerics
