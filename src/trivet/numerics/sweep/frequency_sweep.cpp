// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sweep/frequency_sweep.h"

#include <algorithm>
#include <cmath>
#include <mutex>
// Fallback of SweepWorkspace for solutions without pivoting that are not accepted.
#include <cassert>

#include "trivet/foundation/index.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/numerics/linalg/refined_solution.h"
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

/// Recomputes the marked frequencies and those with a backward error that is not accepted.
void SweepWorkspace::recompute_rejected(std::vector<char> marked, long count) {
  assert(count <= chunk && (marked.empty() || marked.size() == to_size(count)));
  for (std::size_t f = 0; f < to_size(count); ++f)
    if (!(error_.data()[f] <= accepted_backward_error)) {
      marked.resize(to_size(count));
      marked[f] = 1;
    }
  if (!marked.empty()) recompute(marked);
}

/// Recomputes the marked frequencies by LU with partial pivoting in lanes, and those still not accepted one at a time.
void SweepWorkspace::recompute(const std::vector<char>& marked) {
  const Planes q = planes_in(q_);
  std::vector<long> which;
  for (std::size_t f = 0; f < marked.size(); ++f)
    if (marked[f]) which.push_back(static_cast<long>(f));
  const auto n = to_index(plan_->size());
  const auto count = static_cast<long>(which.size());
  assert(count > 0 && "there are frequencies to recompute");
  std::vector<char> settled(which.size());
  if (plan_->solver() != SweepSolver::pivoted) counts_.fallbacks += static_cast<int>(count);
  if (plan_->solver() != SweepSolver::pivoted && plan_->solver() != SweepSolver::blocks) {
    which.resize(to_size(sweep_kernels::filled_up(count, sweep_kernels::widest_pack)), which.back());
    const auto width = static_cast<long>(which.size());
    const Planes all_parts = plan_->part_ ? planes_in(part_) : Planes{};
    std::vector<double> omega(which.size()), error(which.size());
    std::vector<double> memory(2 * which.size() * to_size(2 * n + (plan_->part_ ? n * n : 0)));
    auto planes = [&, next = memory.data()](Eigen::Index entries) mutable {
      const Planes these{next, next + entries * width, width};
      next += 2 * entries * width;
      return these;
    };
    const Planes load = planes(n), solution = planes(n), part = plan_->part_ ? planes(n * n) : Planes{};
    for (long k = 0; k < width; ++k) {
      const long f = which[k];
      omega[k] = omega_.data()[f];
      const Eigen::VectorXcd h = load_at(f);
      for (Eigen::Index i = 0; i < n; ++i) load.put(i * width + k, h(i));
      for (Eigen::Index e = 0; e < n * n && part.re; ++e)
        part.put(e * width + k, {all_parts.re[e * chunk + f], all_parts.im[e * chunk + f]});
    }
    const sweep_kernels::Batch batch{omega.data(), width, load, part, plan_->scale_.data(), solution, error.data()};
    (void)sweep_kernels::solve_pivoted(plain(), batch);
    const std::vector<double> singular = error;
    sweep_kernels::backward_errors(plain(), batch);
    for (std::size_t k = 0; k < settled.size(); ++k) {
      settled[k] = singular[k] == 0 && error[k] <= accepted_backward_error;
      error_.data()[which[k]] = error[k];
      for (Eigen::Index i = 0; i < n; ++i)
        q.put(i * q.stride + which[k],
              {solution.re[i * width + static_cast<long>(k)], solution.im[i * width + static_cast<long>(k)]});
    }
  }
  for (std::size_t k = 0; k < settled.size(); ++k)
    if (!settled[k]) recompute_one(which[k]);
}

/// h of one frequency of the chunk in scaled coordinates.
Eigen::VectorXcd SweepWorkspace::load_at(long f) const {
  if (plan_->solver() == SweepSolver::aimed || plan_->solver() == SweepSolver::blocks ||
      plan_->solver() == SweepSolver::one_frequency)
    return plan_->load_.at(omega_.data()[f]);
  Eigen::VectorXcd h(plan_->size());
  const Planes load = planes_in(load_);
  for (Eigen::Index i = 0; i < h.size(); ++i) {
    h(i) = {load.re[i * chunk + f], load.im[i * chunk + f]};
  }
  return h;
}

/// Solves one frequency with partial pivoting and one step of refinement; NaN if Z is singular.
void SweepWorkspace::recompute_one(long f) {
  const Planes q = planes_in(q_);
  const auto n = to_index(plan_->size());
  Eigen::MatrixXcd z =
      plan_->blocks_ ? plan_->blocks_->scaled_matrix(omega_.data()[f]) : plan_->matrices_.at(omega_.data()[f]);
  const Planes part = plan_->part_ && !plan_->evaluates_part_per_frequency() ? planes_in(part_) : Planes{};
  for (Eigen::Index i = 0; i < n && part.re; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const long at = (i * n + j) * chunk + f;
      z(i, j) += Complex(part.re[at], part.im[at]);
    }
  Eigen::VectorXcd h = load_at(f);
  if (plan_->evaluates_part_per_frequency()) {
    Eigen::MatrixXcd z_part = Eigen::MatrixXcd::Zero(n, n);
    Eigen::VectorXcd h_part = Eigen::VectorXcd::Zero(n);
    plan_->part_.add(omega_.data()[f], z_part, h_part);
    z += plan_->scale_.asDiagonal() * z_part * plan_->scale_.asDiagonal();
    h += plan_->scale_.cwiseProduct(h_part);
  }
  const PivotedSolution solution = pivoted_solution(z, h);
  assert((std::isnan(solution.backward_error) || solution.x.allFinite()) && "either singular or solved");
  error_.data()[f] = solution.backward_error;
  if (std::isnan(solution.backward_error)) ++counts_.singular;
  for (Eigen::Index i = 0; i < n; ++i) q.put(i * q.stride + f, plan_->scale_(i) * solution.x(i));
}

}  // namespace trivet::numerics
