// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/batch/sweep_maxima.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/numerics/batch/maxima_from_roots.h"
#include "trivet/numerics/sweep/sweep_workspace.h"

namespace trivet::numerics {
namespace {

constexpr std::size_t designs_together = 64;
constexpr std::size_t least_for_poles =
    32;  // frequencies; the poles of a design cost as much as some sixty frequencies solved directly
using foundation::infinity;

/// Computes one row of the result.
void find_maxima(SweepWorkspace& workspace, const SweepPlan& plan, const std::vector<double>& omega,
                 const SweepOptions& options, SweepMaxima& result, Eigen::Index row) {
  const int n = plan.size();
  std::vector<double> square(to_size(n), -1.0), where(to_size(n));
  workspace.prepare(plan);
  for (std::size_t at = 0; at < omega.size(); at += to_size(SweepWorkspace::chunk)) {
    const auto count = static_cast<long>(std::min(omega.size() - at, to_size(SweepWorkspace::chunk)));
    const int singular = workspace.counts().singular;
    const Planes q = workspace.solve(&omega[at], count, options.every_backward_error);
    workspace.raise_maxima(q, square.data(), where.data());
    for (long f = 0; f < count && workspace.counts().singular > singular; ++f)
      if (std::isnan(q.re[f]) && square[0] < infinity) {
        std::fill(square.begin(), square.end(), infinity);
        std::fill(where.begin(), where.end(), omega[at + to_size(f)]);
      }
  }
  for (int j = 0; j < n; ++j) {
    result.amplitude(row, j) = std::sqrt(square[to_size(j)]);
    result.angular_frequency(row, j) = where[to_size(j)];
  }
}

/// Solves designs first … last − 1 from their poles, one table at a time. @return the designs without good poles
std::vector<Eigen::Index> by_poles(const Designs& designs, Eigen::Index first, Eigen::Index last,
                                   const std::vector<double>& omega, SweepMaxima& result) {
  RootTable table{};
  TableMaxima maxima;
  std::vector<Eigen::Index> open;
  for (; first < last; first += table_lanes) {
    roots_of_designs(designs, first, table);
    maxima_from_roots(table, omega, maxima);
    for (int lane = 0; lane < table_lanes && first + lane < last; ++lane) {
      if (!table.good[lane] || !maxima.known[lane]) {
        open.push_back(first + lane);
        continue;
      }
      for (int j = 0; j < table.coordinates; ++j) {
        result.amplitude(first + lane, j) = maxima.amplitude[j][lane];
        result.angular_frequency(first + lane, j) = maxima.angular_frequency[j][lane];
      }
    }
  }
  return open;
}

SweepMaxima no_maxima(Eigen::Index designs, Eigen::Index n) {
  return {{}, Eigen::ArrayXXd::Zero(designs, n), Eigen::ArrayXXd::Zero(designs, n)};
}

void require_frequencies(const std::vector<double>& omega) {
  if (omega.empty())
    throw foundation::InvalidInput("largest amplitudes: no frequency is given; at least one is required");
}

}  // namespace

SweepMaxima sweep_maxima(const DynamicMatrices& matrices, const Load& load, const std::vector<double>& omega,
                         const SweepOptions& options) {
  require_frequencies(omega);
  SweepMaxima result = no_maxima(1, matrices.size());
  result.angular_frequency.setConstant(omega.front());
  if (load.vanishes()) return result;
  SweepWorkspace workspace;
  find_maxima(workspace, SweepPlan(matrices, load), omega, options, result, 0);
  static_cast<SweepCounts&>(result) = workspace.counts();
  return result;
}

SweepMaxima sweep_maxima(const Designs& designs, const std::vector<double>& omega, const SweepOptions& options) {
  require_shapes(designs, "largest amplitudes of designs");
  require_frequencies(omega);
  const auto count = to_size(designs.count());
  SweepMaxima result = no_maxima(designs.count(), designs.coordinates());
  result.angular_frequency.setConstant(omega.front());
  const bool poles_pay =
      !options.every_backward_error && designs.coordinates() <= most_pairs && omega.size() >= least_for_poles;
  std::mutex adding;
  const int threads = sweep_threads(count * omega.size(), options.threads);
  foundation::parallel_for(
      count, {.size = designs_together, .threads = threads, .progress = options.progress, .task = "designs"},
      [&](std::size_t first, std::size_t last) {
        SweepWorkspace workspace;
        std::vector<Eigen::Index> open;
        const auto from = to_index(first), to = to_index(last);
        if (poles_pay) open = by_poles(designs, from, to, omega, result);
        else
          for (Eigen::Index design = from; design < to; ++design) open.push_back(design);
        for (const Eigen::Index design : open) {
          const Eigen::VectorXcd load =
              designs.load.row(designs.load.rows() > 1 ? design : 0).matrix().transpose().cast<Complex>();
          if (load.isZero(0)) continue;
          find_maxima(workspace, SweepPlan(matrices_of(designs, design), load), omega, options, result, design);
        }
        const std::lock_guard lock(adding);
        result.add(workspace.counts());
      });
  return result;
}

}  // namespace trivet::numerics
