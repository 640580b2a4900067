// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/block_sweep.cpp"
#include <hwy/foreach_target.h>
#include <hwy/aligned_allocator.h>
#include <hwy/highway.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "trivet/numerics/block_kernels-inl.h"
#include "trivet/numerics/frequency_sweep.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

constexpr int six = 6;

/// Aligned for the instruction set, which std::vector is not here.
using Packs = hwy::AlignedFreeUniquePtr<ComplexPack[]>;
Packs packs(std::size_t count) { return hwy::AllocateAligned<ComplexPack>(std::max<std::size_t>(count, 1)); }

/// Memory of one pack of frequencies after another.
class BlockSolver {
 public:
  explicit BlockSolver(const BlockPlan& plan)
      : plan_(plan), factors_(packs(plan.factors)), plain_(packs(plan.widest)), q_(packs(plan.rows)), residual_(packs(plan.rows)) {}

  /// Solves; returns the backward errors. Results stay in `solution()`.
  Pack solve(const Pack& omega, const ComplexPack* term_factors) {
    at_ = {omega, hn::Mul(omega, omega)};
    set_load(term_factors, q_.get());
    smallest_ = all(std::numeric_limits<double>::max());
    for (const BlockPlan::Column& column : plan_.columns) eliminate(column, q_.get());
    substitute_back(q_.get());
    return seen_backward_error(term_factors);
  }

  [[nodiscard]] const ComplexPack* solution() const { return q_.get(); }

  /// Measures the backward error in full where that seen was not accepted, and refines there until it is small or no longer falls.
  Pack refine(Pack error, const ComplexPack* term_factors) {
    const Pack accepted = all(accepted_backward_error);
    const LaneMask doubtful = hn::Not(certain(error));
    constexpr int most_steps = 3;
    for (int step = 0; step <= most_steps; ++step) {
      const Pack measured = backward_error(term_factors);
      error = hn::IfThenElse(doubtful, measured, error);
      const LaneMask bad = hn::AndNot(hn::Le(measured, accepted), doubtful);
      if (step == most_steps || hn::AllFalse(Lanes(), bad)) break;
      forward_all(residual_.get());
      substitute_back(residual_.get());
      for (std::size_t i = 0; i < plan_.rows; ++i) {
        const ComplexPack better = q_[i] + residual_[i];
        q_[i] = {hn::IfThenElse(bad, better.re, q_[i].re), hn::IfThenElse(bad, better.im, q_[i].im)};
      }
    }
    return error;
  }

  /// Lanes whose residual need not be looked at in full.
  static LaneMask certain(const Pack& error) { return hn::Le(error, accepted_as_seen()); }

 private:
  /// One direction may see less of a residual than there is.
  static Pack accepted_as_seen() { return all(accepted_backward_error / 4); }

  void set_load(const ComplexPack* term_factors, ComplexPack* HWY_RESTRICT h) const {
    for (std::size_t i = 0; i < plan_.rows; ++i) h[i] = {all(0.0), all(0.0)};
    for (std::size_t t = 0; t < plan_.load.size(); ++t)
      for (const BlockPlan::LoadRow& row : plan_.load[t].rows) h[row.row] = add_product(h[row.row], term_factors[t], {all(row.value.real()), all(row.value.imag())});
  }

  void assemble_block(const BlockPlan::Block& block) {
    ComplexPack* place = factors_.get() + block.place;
    if (block.entries() == six * six) assemble(six * six, block, plan_.values.data(), at_, place);
    else if (block.entries() == six * (six + 1) / 2) assemble(six * (six + 1) / 2, block, plan_.values.data(), at_, place);
    else assemble(block.entries(), block, plan_.values.data(), at_, place);
  }

  void eliminate(const BlockPlan::Column& column, ComplexPack* h) {
    const BlockPlan::Block& diagonal = plan_.blocks[static_cast<std::size_t>(column.diagonal)];
    if (column.first) assemble_block(diagonal);
    ComplexPack* l = factors_.get() + diagonal.place;
    if (column.size == six) factor(six, l, smallest_);
    else factor(column.size, l, smallest_);
    if (column.loaded) {
      if (column.size == six) forward(six, l, h + column.row);
      else forward(column.size, l, h + column.row);
    }
    ComplexPack* plain = plain_.get();
    for (std::size_t k = column.below_first; k < column.below_end; ++k) {
      const BlockPlan::Below& below = plan_.below[k];
      const BlockPlan::Block& block = plan_.blocks[static_cast<std::size_t>(below.block)];
      if (below.first) assemble_block(block);
      ComplexPack* a = factors_.get() + block.place;
      if (block.rows == six && block.columns == six) divide(six, six, l, a, plain);
      else divide(block.rows, block.columns, l, a, plain);
      plain += block.entries();
      if (column.loaded) forward_block(block, h + column.row, h + below.row);
    }
    for (std::size_t k = column.update_first; k < column.update_end; ++k) update(column, plan_.updates[k]);
    if (column.loaded)
      for (int i = 0; i < column.size; ++i) h[column.row + static_cast<std::size_t>(i)] = h[column.row + static_cast<std::size_t>(i)] * l[packed(i, i)];
  }

  void update(const BlockPlan::Column& column, const BlockPlan::Update& u) {
    const BlockPlan::Block& target = plan_.blocks[static_cast<std::size_t>(u.target)];
    if (u.first) assemble_block(target);
    const BlockPlan::Block& left = plan_.blocks[static_cast<std::size_t>(plan_.below[column.below_first + static_cast<std::size_t>(u.left)].block)];
    const BlockPlan::Block& first = plan_.blocks[static_cast<std::size_t>(plan_.below[column.below_first].block)];
    const BlockPlan::Block& right = plan_.blocks[static_cast<std::size_t>(plan_.below[column.below_first + static_cast<std::size_t>(u.right)].block)];
    const ComplexPack* l = factors_.get() + left.place;
    const ComplexPack* plain = plain_.get() + (right.place - first.place);  // the blocks of a column follow each other
    ComplexPack* a = factors_.get() + target.place;
    if (target.rows == six && target.columns == six && column.size == six) {
      if (target.diagonal) subtract(true, six, six, six, l, plain, a);
      else subtract(false, six, six, six, l, plain, a);
    } else {
      subtract(target.diagonal, target.rows, target.columns, column.size, l, plain, a);
    }
  }

  void forward_block(const BlockPlan::Block& block, const ComplexPack* x, ComplexPack* below) const {
    const ComplexPack* l = factors_.get() + block.place;
    if (block.rows == six && block.columns == six) forward_below(six, six, l, x, below);
    else forward_below(block.rows, block.columns, l, x, below);
  }

  /// D⁻¹L⁻¹ for a right side without known zeros.
  void forward_all(ComplexPack* h) const {
    for (const BlockPlan::Column& column : plan_.columns) {
      const ComplexPack* l = factors_.get() + plan_.blocks[static_cast<std::size_t>(column.diagonal)].place;
      forward(column.size, l, h + column.row);
      for (std::size_t k = column.below_first; k < column.below_end; ++k)
        forward_block(plan_.blocks[static_cast<std::size_t>(plan_.below[k].block)], h + column.row, h + plan_.below[k].row);
      for (int i = 0; i < column.size; ++i) h[column.row + static_cast<std::size_t>(i)] = h[column.row + static_cast<std::size_t>(i)] * l[packed(i, i)];
    }
  }

  HWY_INLINE void column_back(int size, const BlockPlan::Column& column, ComplexPack* x) const {
    ComplexPack sum[largest_kernel_block];
    for (int i = 0; i < size; ++i) sum[i] = x[column.row + static_cast<std::size_t>(i)];
    for (std::size_t k = column.below_first; k < column.below_end; ++k) {
      const BlockPlan::Block& block = plan_.blocks[static_cast<std::size_t>(plan_.below[k].block)];
      const ComplexPack* l = factors_.get() + block.place;
      if (block.rows == six) backward_below(six, size, l, x + plan_.below[k].row, sum);
      else backward_below(block.rows, size, l, x + plan_.below[k].row, sum);
    }
    backward(size, factors_.get() + plan_.blocks[static_cast<std::size_t>(column.diagonal)].place, sum);
    for (int i = 0; i < size; ++i) x[column.row + static_cast<std::size_t>(i)] = sum[i];
  }

  void substitute_back(ComplexPack* x) const {
    for (std::size_t j = plan_.columns.size(); j-- > 0;) {
      const BlockPlan::Column& column = plan_.columns[j];
      if (column.size == six) column_back(six, column, x);
      else column_back(column.size, column, x);
    }
  }

  /// Pivots that are nothing but round-off leave a small residual and a meaningless solution.
  Pack refused_pivots(const Pack& error, const Pack& norm) const {
    const double negligible = 16 * static_cast<double>(plan_.rows) * std::numeric_limits<double>::epsilon();
    const Pack limit = hn::Mul(all(negligible), norm);
    return hn::IfThenElse(hn::Gt(smallest_, hn::Mul(limit, limit)), error, all(std::numeric_limits<double>::infinity()));
  }

  /// The residual along one direction, |wᵀ(Zq − h)|, over lower bounds of ‖Z‖∞ and ‖q‖∞.
  Pack seen_backward_error(const ComplexPack* term_factors) const {
    ComplexPack seen{all(0.0), all(0.0)};
    Pack norm = all(0.0), size = all(0.0);
    for (std::size_t i = 0; i < plan_.rows; ++i) {
      ComplexPack z{hn::NegMulAdd(at_.square, all(plan_.weighted_A[i]), all(plan_.weighted_K[i])), hn::MulAdd(at_.omega, all(plan_.weighted_B[i]), all(plan_.weighted_loss[i]))};
      seen = add_product(seen, z, q_[i]);
      norm = hn::Max(norm, squared_modulus(z));
      size = hn::Max(size, squared_modulus(q_[i]));
    }
    for (std::size_t t = 0; t < plan_.load.size(); ++t) {
      std::complex<double> sum = 0;
      for (const BlockPlan::LoadRow& row : plan_.load[t].rows) sum += plan_.weight[row.row] * row.value;
      seen = subtract_product(seen, term_factors[t], {all(sum.real()), all(sum.imag())});
    }
    norm = hn::Sqrt(norm);
    return refused_pivots(hn::Div(one_norm(seen), hn::Mul(norm, hn::Sqrt(size))), norm);
  }

  /// The same in full; leaves h − Zq in `residual_`.
  Pack backward_error(const ComplexPack* term_factors) {
    set_load(term_factors, residual_.get());
    Pack worst = all(0.0), norm = all(0.0), size = all(0.0), load = all(0.0);
    for (std::size_t i = 0; i < plan_.rows; ++i) {
      ComplexPack r = residual_[i];
      load = hn::Max(load, one_norm(r));
      Pack row = all(0.0);
      for (std::size_t k = plan_.entry_first[i]; k < plan_.entry_first[i + 1]; ++k) {
        const BlockPlan::Entry& e = plan_.entries[k];
        const ComplexPack z{hn::NegMulAdd(at_.square, all(e.A), all(e.K)), hn::MulAdd(at_.omega, all(e.B), all(e.loss))};
        row = hn::Add(row, one_norm(z));
        r = subtract_product(r, z, q_[e.column]);
      }
      residual_[i] = r;
      // A comparison with NaN is false: it must not hide behind a maximum.
      worst = hn::IfThenElse(hn::Le(one_norm(r), worst), worst, one_norm(r));
      norm = hn::Max(norm, row);
      size = hn::Max(size, one_norm(q_[i]));
    }
    return refused_pivots(hn::Div(worst, hn::MulAdd(norm, size, load)), norm);
  }

  const BlockPlan& plan_;
  Packs factors_, plain_, q_, residual_;
  Frequencies at_{};
  Pack smallest_{};
};

int solve_blocks(const BlockPlan& plan, const double* omega, Eigen::Index count, std::complex<double>* response, Eigen::Index stride, double* backward_error) {
  const int lanes = lane_count();
  BlockSolver solver(plan);
  const Packs term_factors = packs(plan.load.size());
  HWY_ALIGN double frequencies[8];
  HWY_ALIGN double re[8];
  HWY_ALIGN double im[8];
  int doubtful = 0;
  for (Eigen::Index first = 0; first < count; first += lanes) {
    const auto filled = static_cast<int>(std::min<Eigen::Index>(lanes, count - first));
    for (int lane = 0; lane < lanes; ++lane) frequencies[lane] = omega[first + std::min(lane, filled - 1)];
    for (std::size_t t = 0; t < plan.load.size(); ++t) {
      for (int lane = 0; lane < lanes; ++lane) {
        const std::complex<double> factor = load_factor(plan.load[t].power, plan.load[t].delay, frequencies[lane]);
        re[lane] = factor.real(), im[lane] = factor.imag();
      }
      term_factors[t] = {hn::Load(Lanes(), re), hn::Load(Lanes(), im)};
    }
    Pack error = solver.solve(hn::Load(Lanes(), frequencies), term_factors.get());
    if (!hn::AllTrue(Lanes(), BlockSolver::certain(error))) {
      const LaneMask present = hn::FirstN(Lanes(), static_cast<std::size_t>(filled));
      doubtful += static_cast<int>(hn::CountTrue(Lanes(), hn::AndNot(BlockSolver::certain(error), present)));
      error = solver.refine(error, term_factors.get());
    }
    const ComplexPack* q = solver.solution();
    for (std::size_t i = 0; i < plan.rows; ++i) {
      const Pack scale = all(plan.scale[i]);
      hn::Store(hn::Mul(scale, q[i].re), Lanes(), re);
      hn::Store(hn::Mul(scale, q[i].im), Lanes(), im);
      for (int lane = 0; lane < filled; ++lane) response[(first + lane) * stride + static_cast<Eigen::Index>(plan.given_row[i])] = {re[lane], im[lane]};
    }
    hn::Store(error, Lanes(), re);
    std::copy(re, re + filled, backward_error + first);
  }
  return doubtful;
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "trivet/numerics/block_sweep.h"

namespace trivet::numerics {

HWY_EXPORT(solve_blocks);

BlockSweep::BlockSweep(const DynamicMatrices& matrices, const Load& load) {
  const Eigen::VectorXd d = unit_scale(matrices);
  plan_ = block_plan(scaled(matrices, d), load.scaled(d), d);
}

int BlockSweep::solve(const double* omega, Eigen::Index count, Eigen::Ref<Eigen::MatrixXcd> response, Eigen::Ref<Eigen::VectorXd> backward_error) const {
  return HWY_DYNAMIC_DISPATCH(solve_blocks)(plan_, omega, count, response.data(), response.outerStride(), backward_error.data());
}

}  // namespace trivet::numerics
#endif
