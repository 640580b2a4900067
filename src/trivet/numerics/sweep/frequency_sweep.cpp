// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sweep/frequency_sweep.h"

#include <algorithm>
#include <mutex>

#include "trivet/foundation/index.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/numerics/sweep/sweep_workspace.h"

namespace trivet::numerics {
namespace {

constexpr std::size_t piece = 16 * to_size(SweepWorkspace::chunk);

/// Threads for so many solutions of six coordinates: one if a second would start after the first has finished.
int sweep_threads(std::size_t solutions, int wanted) { return solutions < 20000 ? 1 : wanted; }

/// Solves all chunks; consume(first, count, planes, errors) receives the solutions from `first` on.
template <typename Consume>
SweepCounts for_each_chunk(const SweepPlan& plan, const std::vector<double>& omega, const SweepOptions& options,
                           const Consume& consume) {
  SweepCounts counts;
  std::mutex adding;
  const int threads = sweep_threads(plan.weight() * omega.size(), options.threads);
  foundation::parallel_for(omega.size(),
                           {.size = plan.weight() > 1 ? piece / 4 : piece,
                            .threads = threads,
                            .progress = options.progress,
                            .task = "frequencies"},
                           [&](std::size_t first, std::size_t last) {
                             SweepWorkspace workspace(plan);
                             for (std::size_t at = first; at < last; at += to_size(SweepWorkspace::chunk)) {
                               const auto count =
                                   static_cast<long>(std::min(last - at, to_size(SweepWorkspace::chunk)));
                               const Planes q = workspace.solve(&omega[at], count, options.every_backward_error);
                               consume(static_cast<long>(at), count, q, workspace.backward_errors());
                             }
                             const std::lock_guard lock(adding);
                             counts.add(workspace.counts());
                           });
  return counts;
}

}  // namespace

SweepResult sweep(const DynamicMatrices& matrices, const Load& load, const FrequencyPart& part,
                  const std::vector<double>& omega, const SweepOptions& options) {
  const Eigen::Index n = matrices.size(), count = to_index(omega.size());
  SweepResult result;
  if (load.vanishes() && !part) {
    result.response.setZero(n, count);
    if (options.every_backward_error) result.backward_error.setZero(count);
    return result;
  }
  result.response.resize(n, count);
  if (options.every_backward_error) result.backward_error.resize(count);
  static_cast<SweepCounts&>(result) =
      for_each_chunk(SweepPlan(matrices, load, part), omega, options,
                     [&](long first, long taken, const Planes& q, const double* errors) {
                       constexpr long line = 8;  // numbers in a cache line
                       for (long some = 0; some < taken; some += line)
                         for (Eigen::Index j = 0; j < n; ++j)
                           for (long f = some; f < std::min(some + line, taken); ++f)
                             result.response(j, first + f) = {q.re[j * q.stride + f], q.im[j * q.stride + f]};
                       if (options.every_backward_error)
                         std::copy_n(errors, taken, result.backward_error.data() + first);
                     });
  return result;
}

SweepResult sweep(const DynamicMatrices& matrices, const Load& load, const std::vector<double>& omega,
                  const SweepOptions& options) {
  return sweep(matrices, load, {}, omega, options);
}

}  // namespace trivet::numerics
