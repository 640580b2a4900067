// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sweep/frequency_sweep.h"

#include <algorithm>
#include <atomic>
#include <mutex>

#include "trivet/foundation/index.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/numerics/sweep/pole_sweep.h"
#include "trivet/numerics/sweep/sweep_workspace.h"

namespace trivet::numerics {
namespace {

constexpr std::size_t piece = 16 * to_size(SweepWorkspace::chunk);

/// Solves all chunks; target(first) returns the destination of the solutions from `first` on, consume(first, count,
/// planes, errors) receives them.
template <typename Target, typename Consume>
SweepCounts for_each_chunk(const SweepPlan& plan, const std::vector<double>& omega, const SweepOptions& options,
                           const Target& target, const Consume& consume) {
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
                               const Planes q = workspace.solve(&omega[at], count, options.every_backward_error,
                                                                target(static_cast<long>(at)));
                               consume(static_cast<long>(at), count, q, workspace.backward_errors());
                             }
                             const std::lock_guard lock(adding);
                             counts.add(workspace.counts());
                           });
  return counts;
}

/// Number of frequencies from which on poles are faster, measured at six coordinates with AVX-512: their set-up takes 8
/// µs with its code in the cache, else twice that; a direct solution takes 7 ns more than a sum over poles.
constexpr std::size_t worth_poles = 2400;

/// Computes the result by sums over proven poles. @return false if that is not possible
bool swept_by_poles(const DynamicMatrices& matrices, const Load& load, const std::vector<double>& omega,
                    SweepPlanes& result, const SweepOptions& options) {
  if (options.every_backward_error || omega.size() < worth_poles || !load.is_constant()) return false;
  const std::optional<PoleSweep> poles = PoleSweep::try_build(matrices, load.at(0));
  if (!poles) return false;
  std::atomic<bool> good = true;
  foundation::parallel_for(omega.size(),
                           {piece, sweep_threads(omega.size(), options.threads), options.progress, "frequencies"},
                           [&](std::size_t first, std::size_t last) {
                             const auto at = to_index(first), taken = to_index(last - first);
                             if (!poles->response(Eigen::Map<const Eigen::ArrayXd>(&omega[first], taken),
                                                  result.re.middleRows(at, taken), result.im.middleRows(at, taken)))
                               good = false;
                           });
  return good;
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
  const auto own = [](long) { return Planes{}; };
  static_cast<SweepCounts&>(result) =
      for_each_chunk(SweepPlan(matrices, load, part), omega, options, own,
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

void sweep(const DynamicMatrices& matrices, const Load& load, const std::vector<double>& omega, SweepPlanes& result,
           const SweepOptions& options) {
  const Eigen::Index n = matrices.size(), count = to_index(omega.size());
  result.re.resize(count, n);
  result.im.resize(count, n);
  result.backward_error.resize(options.every_backward_error ? count : 0);
  static_cast<SweepCounts&>(result) = {};
  if (load.vanishes()) {
    result.re.setZero();
    result.im.setZero();
    result.backward_error.setZero();
    return;
  }
  if (swept_by_poles(matrices, load, omega, result, options)) return;
  const auto target = [&](long first) { return Planes{result.re.data() + first, result.im.data() + first, count}; };
  static_cast<SweepCounts&>(result) =
      for_each_chunk(SweepPlan(matrices, load), omega, options, target,
                     [&](long first, long taken, const Planes& q, const double* errors) {
                       const Planes to = target(first);
                       for (Eigen::Index j = 0; j < n && q.re != to.re; ++j) {
                         std::copy_n(q.re + j * q.stride, taken, to.re + j * to.stride);
                         std::copy_n(q.im + j * q.stride, taken, to.im + j * to.stride);
                       }
                       if (options.every_backward_error)
                         std::copy_n(errors, taken, result.backward_error.data() + first);
                     });
}

}  // namespace trivet::numerics
