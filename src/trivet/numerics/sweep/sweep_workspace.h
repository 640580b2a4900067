// SPDX-License-Identifier: BSD-3-Clause
// Solves the frequencies of one system, chunk by chunk.
#pragma once

#include "trivet/numerics/lanes/line_memory.h"
#include "trivet/numerics/sweep/sweep_plan.h"

namespace trivet::numerics {

/// Memory for one chunk of frequencies on one thread, and its solutions.
class SweepWorkspace {
 public:
  static constexpr long chunk = 256;  ///< frequencies; with six coordinates they stay in the nearest cache

  SweepWorkspace() = default;
  explicit SweepWorkspace(const SweepPlan& plan) { prepare(plan); }

  /// Switches to another system; memory of the same size is reused. The counts continue.
  void prepare(const SweepPlan& plan);

  /// Solutions at `count` ≤ `chunk` frequencies, in `target`, or in own planes if that is null or `count` must be
  /// padded.
  /// @return where they are
  Planes solve(const double* omega, long count, bool every_backward_error, Planes target = {});

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
  void solve_blocks(bool every_backward_error, const Planes& q);
  void recompute_rejected(std::vector<char> marked, long count, const Planes& q);
  void recompute(const std::vector<char>& marked, const Planes& q);
  void recompute_one(long f, const Planes& q);
  [[nodiscard]] Eigen::VectorXcd load_at(long f) const;

  const SweepPlan* plan_ = nullptr;
  /// Coefficients in plain coordinates; an aimed system needs them only for residuals and pivoting.
  const sweep_kernels::Coefficients& plain();

  std::optional<sweep_kernels::Coefficients> plain_;
  LineMemory omega_, load_, amplitude_, part_, q_, error_, blocks_;
  Eigen::MatrixXcd z_part_;  ///< 0, except for entries that a part adds outside its coupled rows
  long padded_ = 0;
  int load_filled_ = 0;  ///< 1: for the solver; 2: also for residuals
  bool load_finite_ = true;
  SweepCounts counts_;
};

}  // namespace trivet::numerics
