// SPDX-License-Identifier: BSD-3-Clause
// Solves and checks every frequency, whatever their number. `sweep` itself sums over poles if these are proven and many
// frequencies are requested, so its time would not measure the solver.
#pragma once

#include <algorithm>
#include <vector>

#include "trivet/foundation/index.h"
#include "trivet/numerics/sweep/frequency_sweep.h"
#include "trivet/numerics/sweep/sweep_workspace.h"

namespace trivet::benchmarks {

/// Writes to `result`, on one thread; the plan is made again each time.
inline void solve_directly(const numerics::DynamicMatrices& matrices, const numerics::Load& load,
                           const std::vector<double>& omega, numerics::SweepPlanes& result) {
  const auto count = static_cast<long>(omega.size());
  result.re.resize(count, matrices.size());
  result.im.resize(count, matrices.size());
  const numerics::SweepPlan plan(matrices, load);
  numerics::SweepWorkspace workspace(plan);
  for (long at = 0; at < count; at += numerics::SweepWorkspace::chunk) {
    const long taken = std::min(numerics::SweepWorkspace::chunk, count - at);
    const numerics::Planes to{result.re.data() + at, result.im.data() + at, count};
    const numerics::Planes q = workspace.solve(&omega[to_size(at)], taken, false, to);
    for (long j = 0; j < matrices.size() && q.re != to.re; ++j) {  // a chunk that is not full
      std::copy_n(q.re + j * q.stride, taken, to.re + j * to.stride);
      std::copy_n(q.im + j * q.stride, taken, to.im + j * to.stride);
    }
  }
  static_cast<numerics::SweepCounts&>(result) = workspace.counts();
}

}  // namespace trivet::benchmarks
