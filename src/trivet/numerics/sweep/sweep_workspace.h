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
