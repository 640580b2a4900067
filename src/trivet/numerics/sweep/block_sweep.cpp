// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sweep/block_sweep.h"

#include <cassert>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/sweep/block_sweep.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>

#include "trivet/foundation/index.h"
#include "trivet/numerics/sweep/block_residual-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {
namespace {

/// Number k at `count` frequencies from `first` on; unused lanes repeat the last one.
ComplexPack read(const Planes& from, std::size_t k, Eigen::Index first, int count) {
  assert(count > 0 && from.re != nullptr && "unused lanes repeat a frequency that exists");
  const double *re = from.re + to_index(k) * from.stride + first, *im = from.im + to_index(k) * from.stride + first;
  if (count >= lane_count()) return {hn::LoadU(Lanes(), re), hn::LoadU(Lanes(), im)};
  HWY_ALIGN double padded_re[8];
  HWY_ALIGN double padded_im[8];
  for (int lane = 0; lane < lane_count(); ++lane) {
    padded_re[lane] = re[lane < count ? lane : count - 1];
    padded_im[lane] = im[lane < count ? lane : count - 1];
  }
  return {hn::Load(Lanes(), padded_re), hn::Load(Lanes(), padded_im)};
}

/// Reads the inputs at `count` frequencies from `first` on.
void read_pass(const BlockPlan& plan, const BlockBatch& batch, Eigen::Index first, int count, Pass& p) {
  HWY_ALIGN double omega[8] = {};
  HWY_ALIGN double re[8] = {};
  HWY_ALIGN double im[8] = {};
  const int lanes = lane_count();
  for (int lane = 0; lane < lanes; ++lane) omega[lane] = batch.omega[first + std::min(lane, count - 1)];
  p.at.omega = hn::Load(Lanes(), omega);
  for (std::size_t t = 0; t < plan.load.size(); ++t) {
    for (int lane = 0; lane < lanes; ++lane) {
      const std::complex<double> factor = plan.load[t].given.factor(omega[lane]);
      re[lane] = factor.real(), im[lane] = factor.imag();
    }
    p.terms[t] = {hn::Load(Lanes(), re), hn::Load(Lanes(), im)};
  }
  for (std::size_t k = 0; k < plan.free.size(); ++k)
    p.free[k] = all(plan.free[k].scale) * read(batch.free, plan.free[k].number, first, count);
  for (std::size_t i = 0; plan.given_load && i < plan.rows; ++i)
    p.load[i] = all(plan.scale[i]) * read(batch.load, plan.given_row[i], first, count);
}

void write(const Pack& value, int count, double* to) {
  if (count >= lane_count()) {
    hn::StoreU(value, Lanes(), to);
    return;
  }
  HWY_ALIGN double padded[8];
  hn::Store(value, Lanes(), padded);
  for (int lane = 0; lane < count; ++lane) to[lane] = padded[lane];
}

/// Writes the solutions of `count` frequencies from `first` on, each pack of them after `rows` packs.
void write_solutions(const BlockPlan& plan, const BlockBatch& batch, Eigen::Index first, int count,
                     const ComplexPack* q) {
  const int lanes = lane_count();
  const auto start = [&](std::size_t row) { return to_index(plan.given_row[row]) * batch.response.stride + first; };
  for (std::size_t i = 0; i < plan.rows; ++i) {
    constexpr int line = 8;
    constexpr std::size_t ahead = 2;  // rows ahead, each plane on a separate page: measured
    for (int f = 0; f < count && i + ahead < plan.rows; f += line) {
      hwy::Prefetch(batch.response.re + start(i + ahead) + f);
      hwy::Prefetch(batch.response.im + start(i + ahead) + f);
    }
    const Eigen::Index to = start(i);
    const Pack scale = all(plan.scale[i]);
    const ComplexPack* from = q + i;
    for (int f = 0; f < count; f += lanes, from += plan.rows)
      write(hn::Mul(scale, from->re), count - f, batch.response.re + to + f);
    from = q + i;
    for (int f = 0; f < count; f += lanes, from += plan.rows)
      write(hn::Mul(scale, from->im), count - f, batch.response.im + to + f);
  }
}

/// Solves `count` frequencies from `first` on, at most those of all passes, and writes the solutions to `q`. Returns
/// the number of doubtful ones.
int solve_some(const BlockPlan& plan, const BlockBatch& batch, Eigen::Index first, int count, BlockSolver& solver,
               ComplexPack* q) {
  const int lanes = lane_count();
  const auto filled = [&](int i) { return std::clamp(count - i * lanes, 0, lanes); };
  assert(count > 0 && count <= passes * lanes && BlockPlan::together % (passes * lanes) == 0);
  int doubtful = 0;
  Pack error[passes];
  for (int i = 0; i < passes; ++i) {
    Pass& p = solver.pass(i);
    p.q = q + to_size(i) * plan.rows;
    if (filled(i) > 0) read_pass(plan, batch, first + to_index(i) * lanes, filled(i), p);
    else read_pass(plan, batch, first, filled(0), p);
  }
  solver.solve();
  for (int i = 0; i < passes; ++i) {
    error[i] = batch.measure_all ? all(std::numeric_limits<double>::infinity())
                                 : projected_backward_error(plan, solver.pass(i));
    const LaneMask present = hn::FirstN(Lanes(), to_size(filled(i)));
    doubtful += static_cast<int>(hn::CountTrue(Lanes(), hn::AndNot(certain(error[i]), present)));
  }
  if (doubtful > 0) refine(plan, solver, error);
  for (int i = 0; i < passes; ++i) write(error[i], filled(i), batch.backward_error + first + to_index(i) * lanes);
  return doubtful;
}

int solve_blocks(const BlockPlan& plan, const BlockBatch& batch, double* memory) {
  const int side_by_side = passes * lane_count();
  BlockSolver solver(plan, memory);
  auto* const q = new (memory + passes * plan.packs() * BlockPlan::pack)
      ComplexPack[plan.rows * to_size(BlockPlan::together / lane_count())];
  int doubtful = 0;
  for (Eigen::Index first = 0; first < batch.count; first += BlockPlan::together) {
    const auto count = static_cast<int>(std::min<Eigen::Index>(batch.count - first, BlockPlan::together));
    for (int f = 0; f < count; f += side_by_side)
      doubtful += solve_some(plan, batch, first + f, std::min(count - f, side_by_side), solver,
                             q + plan.rows * to_size(f / lane_count()));
    write_solutions(plan, batch, first, count, q);
  }
  return doubtful;
}

}  // namespace
}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "trivet/numerics/lanes/dispatch.h"

namespace trivet::numerics {

TRIVET_VARIANTS(solve_blocks);

BlockSweep::BlockSweep(const DynamicMatrices& matrices, const Load& load, const std::vector<FreeEntry>& free) {
  const Eigen::VectorXd d = unit_scale(matrices);
  const Load scaled_load = load.scaled(d);
  plan_ = block_plan(matrices, &scaled_load, d, free);
}

BlockSweep::BlockSweep(const DynamicMatrices& matrices, const std::vector<FreeEntry>& free)
    : plan_(block_plan(matrices, nullptr, unit_scale(matrices), free)) {}

int BlockSweep::solve(const BlockBatch& batch, LineMemory& memory) const {
  assert(batch.response.stride >= batch.count && (plan_.free.empty() || batch.free.stride >= batch.count) &&
         (!plan_.given_load || batch.load.stride >= batch.count) && "planes hold all frequencies of the batch");
  memory.resize(plan_.memory());
  return TRIVET_DISPATCH(solve_blocks)(plan_, batch, memory.data());
}

Eigen::MatrixXcd BlockSweep::scaled_matrix(double omega) const {
  const auto n = to_index(plan_.rows);
  const auto given = [&](std::size_t row) { return to_index(plan_.given_row[row]); };
  Eigen::MatrixXcd z = Eigen::MatrixXcd::Zero(n, n);
  for (std::size_t i = 0; i < plan_.rows; ++i)
    for (std::size_t k = plan_.entry_first[i]; k < plan_.entry_first[i + 1]; ++k) {
      const BlockPlan::Entry& e = plan_.entries[k];
      z(given(i), given(e.column)) = {e.K - omega * omega * e.A, e.loss + omega * e.B};
    }
  return z;
}

}  // namespace trivet::numerics
#endif
