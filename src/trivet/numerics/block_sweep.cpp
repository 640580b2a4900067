// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/block_sweep.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include "trivet/numerics/block_kernels-inl.h"
#include "trivet/numerics/block_sweep.h"
#include "trivet/numerics/frequency_sweep.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

constexpr int six = 6;

/// Aligned for the instruction set, which std::vector is not here.
using Packs = std::unique_ptr<ComplexPack[]>;
Packs packs(std::size_t count) { return std::make_unique_for_overwrite<ComplexPack[]>(count); }

/// What belongs to one pack of frequencies.
struct Pass {
  explicit Pass(const BlockPlan& plan) : factors(packs(plan.factors)), left(packs(plan.widest)), plain(packs(plan.widest)), q(packs(plan.rows)), residual(packs(plan.rows)), terms(packs(plan.load.size())), free(packs(plan.free.size())), load(packs(plan.given_load ? plan.rows : 0)) {}
  Packs factors, left, plain, q, residual, terms, free, load;
  Frequencies at{};
};

/// Memory of a few packs of frequencies after another.
class BlockSolver {
 public:
  explicit BlockSolver(const BlockPlan& plan) : plan_(plan), passes_{Pass(plan), Pass(plan)} {}

  [[nodiscard]] Pass& pass(int i) { return passes_[i]; }

  /// Results stand in `q` of each pass.
  void solve() {
    for (Pack& smallest : smallest_) smallest = all(std::numeric_limits<double>::max());
    for (Pass& p : passes_) {
      p.at.square = hn::Mul(p.at.omega, p.at.omega);
      set_load(p, p.q.get());
    }
    for (const BlockPlan::Column& column : plan_.columns) eliminate(column);
    substitute_back(passes_[0].q.get(), passes_[1].q.get(), false);
  }

  /// The residual along one direction, |wᵀ(Zq − h)|, over lower bounds of ‖Z‖∞ and ‖q‖∞.
  [[nodiscard]] Pack seen_backward_error(int pass, bool in_full) const {
    if (in_full || !plan_.free.empty()) return all(std::numeric_limits<double>::infinity());  // not in the weighted sums
    const Pass& p = passes_[pass];
    ComplexPack seen{all(0.0), all(0.0)};
    Pack square = all(0.0), norm = all(0.0);
    for (std::size_t i = 0; i < plan_.rows; ++i) {
      const ComplexPack z{hn::NegMulAdd(p.at.square, all(plan_.weighted_A[i]), all(plan_.weighted_K[i])),
                          hn::MulAdd(p.at.omega, all(plan_.weighted_B[i]), all(plan_.weighted_loss[i]))};
      seen = add_product(seen, z, p.q[i]);
      square = hn::Max(square, squared_modulus(p.q[i]));
    }
    for (std::size_t i = 0; plan_.given_load && i < plan_.rows; ++i) seen = subtract_product(seen, all(plan_.weight[i]), p.load[i]);
    for (std::size_t t = 0; t < plan_.load.size(); ++t)
      seen = subtract_product(seen, p.terms[t], {all(plan_.load[t].weighted.real()), all(plan_.load[t].weighted.imag())});
    for (const std::size_t i : plan_.large_rows) norm = hn::Max(norm, row_norm(i, p));
    return refused_pivots(pass, hn::Div(one_norm(seen), hn::Mul(norm, hn::Sqrt(square))), norm);
  }

  /// Lanes whose residual need not be looked at in full; one direction may see less of it than there is.
  static LaneMask certain(const Pack& error) { return hn::Le(error, all(accepted_backward_error / 4)); }

  /// Measures the backward errors in full where those seen were not certain, and refines there until they are accepted or a few steps are done.
  void refine(Pack* error) const {
    constexpr int most_steps = 3;
    LaneMask doubtful[passes], bad[passes];
    for (int i = 0; i < passes; ++i) doubtful[i] = hn::Not(certain(error[i]));
    for (int step = 0; step <= most_steps; ++step) {
      for (int i = 0; i < passes; ++i) {
        const Pack measured = backward_error(i);
        error[i] = hn::IfThenElse(doubtful[i], measured, error[i]);
        bad[i] = hn::AndNot(hn::Le(measured, all(accepted_backward_error)), doubtful[i]);
      }
      if (step == most_steps || (hn::AllFalse(Lanes(), bad[0]) && hn::AllFalse(Lanes(), bad[1]))) break;
      for (const Pass& p : passes_)
        for (const BlockPlan::Column& column : plan_.columns) substitute_again(column, p, p.residual.get());
      substitute_back(passes_[0].residual.get(), passes_[1].residual.get(), true);
      for (int i = 0; i < passes; ++i)
        for (std::size_t k = 0; k < plan_.rows; ++k) {
          const Pass& p = passes_[i];
          const ComplexPack better = p.q[k] + p.residual[k];
          p.q[k] = {hn::IfThenElse(bad[i], better.re, p.q[k].re), hn::IfThenElse(bad[i], better.im, p.q[k].im)};
        }
    }
  }

 private:
  [[nodiscard]] const BlockPlan::Block& block(int number) const { return plan_.blocks[static_cast<std::size_t>(number)]; }

  /// Only rows of loaded columns are written.
  void set_load(const Pass& p, ComplexPack* HWY_RESTRICT h) const {
    if (plan_.given_load) {
      std::copy_n(p.load.get(), plan_.rows, h);
      return;
    }
    for (const BlockPlan::Column& column : plan_.columns)
      for (std::size_t i = column.row; column.loaded && i < column.row + static_cast<std::size_t>(column.size); ++i) h[i] = {all(0.0), all(0.0)};
    for (std::size_t t = 0; t < plan_.load.size(); ++t)
      for (const BlockPlan::LoadRow& row : plan_.load[t].rows) h[row.row] = add_product(h[row.row], p.terms[t], {all(row.value.real()), all(row.value.imag())});
  }

  [[nodiscard]] Given given(const BlockPlan::Block& b) const { return {b, plan_.values.data()}; }

  void assemble_block(const BlockPlan::Block& b, const Pass& p, ComplexPack* to) const {
    const Given matrices = given(b);
    if (matrices.with_mass()) assemble_with_mass(b.entries(), matrices, p.at, to);
    else assemble(b.entries(), matrices, p.at, to);
    for (std::size_t k = b.free_first; k < b.free_end; ++k) to[plan_.free[k].entry] = to[plan_.free[k].entry] + p.free[k];
  }

  void eliminate(const BlockPlan::Column& column) {
    const BlockPlan::Block& diagonal = block(column.diagonal);
    if (column.first)
      for (const Pass& p : passes_) assemble_block(diagonal, p, p.factors.get() + diagonal.place);
    ComplexPack *first = passes_[0].factors.get() + diagonal.place, *second = passes_[1].factors.get() + diagonal.place;
    if (column.size == six) factor<six>(six, first, second, smallest_);
    else factor<0>(column.size, first, second, smallest_);
    for (std::size_t k = column.below_first; k < column.below_end; ++k)
      for (const Pass& p : passes_) {
        if (column.size == six) divide_below<six>(column, plan_.below[k], p);
        else divide_below<0>(column, plan_.below[k], p);
      }
    for (std::size_t k = column.update_first; k < column.update_end; ++k)
      for (const Pass& p : passes_) {
        if (column.size == six) update<six>(plan_.updates[k], p);
        else update<0>(plan_.updates[k], p);
      }
    if (column.loaded)
      for (const Pass& p : passes_) {
        if (column.size == six) substitute(six, column, p, p.q.get());
        else substitute(column.size, column, p, p.q.get());
      }
  }

  /// Where L of a block below stands as long as its column is at work.
  ComplexPack* left_of(const BlockPlan::Below& below, const Pass& p) const {
    const BlockPlan::Block& b = block(below.block);
    return b.kept ? p.factors.get() + b.place : p.left.get() + below.place;
  }

  template <int fixed>
  HWY_INLINE void divide_below(const BlockPlan::Column& column, const BlockPlan::Below& below, const Pass& p) const {
    const BlockPlan::Block& b = block(below.block);
    const ComplexPack* l = p.factors.get() + block(column.diagonal).place;
    ComplexPack* a = left_of(below, p);
    const Given matrices = given(b);
    if (!b.kept && matrices.stiffness_and_damping()) {
      divide<fixed, true>(b.rows, b.columns, l, a, p.plain.get() + below.place, matrices.K, matrices.B, p.at.omega);
      return;
    }
    if (!b.kept || below.first) assemble_block(b, p, a);
    divide<fixed, false>(b.rows, b.columns, l, a, p.plain.get() + below.place, nullptr, nullptr, p.at.omega);
  }

  template <int fixed>
  HWY_INLINE void update(const BlockPlan::Update& u, const Pass& p) const {
    const BlockPlan::Block& target = block(u.target);
    const BlockPlan::Below& right = plan_.below[u.right];
    const int inner = block(right.block).columns;
    ComplexPack* a = p.factors.get() + target.place;
    const ComplexPack *l = left_of(plan_.below[u.left], p), *plain = p.plain.get() + right.place;
    const Given matrices = given(target);
    if (u.first && target.diagonal && matrices.with_mass() && !target.has_free()) {
      subtract_lower<fixed, true>(target.rows, inner, l, plain, a, matrices, p.at);
      return;
    }
    if (u.first) assemble_block(target, p, a);
    if (target.diagonal) subtract_lower<fixed, false>(target.rows, inner, l, plain, a, matrices, p.at);
    else subtract_full<fixed>(target.rows, target.columns, inner, l, plain, a, matrices, p.at);
  }

  /// One column of D⁻¹L⁻¹ while it is at work.
  HWY_INLINE void substitute(int size, const BlockPlan::Column& column, const Pass& p, ComplexPack* h) const {
    const ComplexPack* l = p.factors.get() + block(column.diagonal).place;
    forward(size, l, h + column.row);
    for (std::size_t k = column.below_first; k < column.below_end; ++k)
      forward_below(block(plan_.below[k].block).rows, size, left_of(plan_.below[k], p), h + column.row, h + plan_.below[k].row);
    divide_by_pivots(size, l, h + column.row);
  }

  /// The same later, when only some blocks of L are left: L_i y = A_i L⁻ᵀD⁻¹y.
  void substitute_again(const BlockPlan::Column& column, const Pass& p, ComplexPack* h) const {
    const ComplexPack* l = p.factors.get() + block(column.diagonal).place;
    ComplexPack* x = h + column.row;
    forward(column.size, l, x);
    ComplexPack back[largest_kernel_block];
    for (int i = 0; i < column.size; ++i) back[i] = x[i];
    divide_by_pivots(column.size, l, back);
    backward(column.size, l, back);
    for (std::size_t k = column.below_first; k < column.below_end; ++k) {
      const BlockPlan::Block& b = block(plan_.below[k].block);
      if (b.kept) forward_below(b.rows, column.size, p.factors.get() + b.place, x, h + plan_.below[k].row);
      else subtract_given(b.rows, column.size, given(b), p.at, back, h + plan_.below[k].row);
    }
    divide_by_pivots(column.size, l, x);
  }

  /// One column of L⁻ᵀ in all passes. Blocks that are not kept: Lᵀx = D⁻¹L⁻¹Aᵀx.
  HWY_INLINE void column_back(int size, const BlockPlan::Column& column, ComplexPack* const* x, bool loaded) const {
    const std::size_t place = block(column.diagonal).place;
    Small sum;
#pragma GCC unroll 2
    for (int p = 0; p < passes; ++p)
#pragma GCC unroll 8
      for (int i = 0; i < size; ++i) sum.x[p][i] = {all(0.0), all(0.0)};
    const Pack one[passes] = {all(-1.0), all(-1.0)}, omega[passes] = {hn::Neg(passes_[0].at.omega), hn::Neg(passes_[1].at.omega)};
    bool pulls = false;
    for (std::size_t k = column.below_first; k < column.below_end; ++k) {
      const BlockPlan::Block& b = block(plan_.below[k].block);
      if (b.kept) continue;
      pulls = true;
      const Given matrices = given(b);
      const ComplexPack* const below[passes] = {x[0] + plan_.below[k].row, x[1] + plan_.below[k].row};
      if (matrices.K != nullptr) add_transposed<false>(b.rows, size, matrices.K, one, below, sum);
      if (matrices.B != nullptr) add_transposed<true>(b.rows, size, matrices.B, omega, below, sum);
      if (matrices.loss != nullptr) add_transposed<true>(b.rows, size, matrices.loss, one, below, sum);
      if (matrices.A != nullptr) {
        const Pack square[passes] = {passes_[0].at.square, passes_[1].at.square};
        add_transposed<false>(b.rows, size, matrices.A, square, below, sum);
      }
    }
#pragma GCC unroll 2
    for (int p = 0; p < passes; ++p) {
      const ComplexPack* l = passes_[p].factors.get() + place;
      if (pulls) {
        forward(size, l, sum.x[p]);
        divide_by_pivots(size, l, sum.x[p]);
      }
      if (loaded)
#pragma GCC unroll 8
        for (int i = 0; i < size; ++i) sum.x[p][i] = x[p][column.row + static_cast<std::size_t>(i)] + sum.x[p][i];
      for (std::size_t k = column.below_first; k < column.below_end; ++k) {
        const BlockPlan::Block& b = block(plan_.below[k].block);
        if (b.kept) backward_below(b.rows, size, passes_[p].factors.get() + b.place, x[p] + plan_.below[k].row, sum.x[p]);
      }
      backward(size, l, sum.x[p]);
#pragma GCC unroll 8
      for (int i = 0; i < size; ++i) x[p][column.row + static_cast<std::size_t>(i)] = sum.x[p][i];
    }
  }

  void substitute_back(ComplexPack* first, ComplexPack* second, bool all_loaded) const {
    ComplexPack* const x[passes] = {first, second};
    for (std::size_t j = plan_.columns.size(); j-- > 0;) {
      const BlockPlan::Column& column = plan_.columns[j];
      if (column.size == six) column_back(six, column, x, all_loaded || column.loaded);
      else column_back(column.size, column, x, all_loaded || column.loaded);
    }
  }

  /// Pivots that are nothing but round-off leave a small residual and a meaningless solution.
  [[nodiscard]] Pack refused_pivots(int pass, const Pack& error, const Pack& norm) const {
    const double negligible = 16 * static_cast<double>(plan_.rows) * std::numeric_limits<double>::epsilon();
    const Pack limit = hn::Mul(all(negligible), norm);
    return hn::IfThenElse(hn::Gt(smallest_[pass], hn::Mul(limit, limit)), error, all(std::numeric_limits<double>::infinity()));
  }

  [[nodiscard]] ComplexPack value(const BlockPlan::Entry& e, const Pass& p) const {
    const ComplexPack z{hn::NegMulAdd(p.at.square, all(e.A), all(e.K)), hn::MulAdd(p.at.omega, all(e.B), all(e.loss))};
    return e.free >= 0 ? z + p.free[static_cast<std::size_t>(e.free)] : z;
  }

  [[nodiscard]] Pack row_norm(std::size_t row, const Pass& p) const {
    Pack sum = all(0.0);
    for (std::size_t k = plan_.entry_first[row]; k < plan_.entry_first[row + 1]; ++k) sum = hn::Add(sum, one_norm(value(plan_.entries[k], p)));
    return sum;
  }

  /// As in `SweepResult`, with |re| + |im| for the modulus. Leaves h − Zq in `residual`.
  [[nodiscard]] Pack backward_error(int pass) const {
    const Pass& p = passes_[pass];
    for (std::size_t i = 0; i < plan_.rows; ++i) p.residual[i] = {all(0.0), all(0.0)};
    set_load(p, p.residual.get());
    Pack worst = all(0.0), norm = all(0.0), size = all(0.0), load = all(0.0), nothing = all(0.0);
    for (std::size_t i = 0; i < plan_.rows; ++i) {
      ComplexPack r = p.residual[i];
      load = hn::Max(load, one_norm(r));
      for (std::size_t k = plan_.entry_first[i]; k < plan_.entry_first[i + 1]; ++k)
        r = subtract_product(r, value(plan_.entries[k], p), p.q[plan_.entries[k].column]);
      p.residual[i] = r;
      worst = hn::Max(worst, one_norm(r));
      nothing = hn::MulAdd(all(0.0), hn::Add(one_norm(r), one_norm(p.q[i])), nothing);  // NaN and ∞ must not hide behind a maximum
      norm = hn::Max(norm, row_norm(i, p));
      size = hn::Max(size, one_norm(p.q[i]));
    }
    return refused_pivots(pass, hn::Div(hn::Add(worst, nothing), hn::MulAdd(norm, size, load)), norm);
  }

  const BlockPlan& plan_;
  Pass passes_[passes];
  Pack smallest_[passes];
};

/// Number k of `count` frequencies from `first` on; lanes that are left over repeat the last.
ComplexPack read(const FrequencyPlanes& from, std::size_t k, Eigen::Index first, int count) {
  const double *re = from.re + static_cast<Eigen::Index>(k) * from.stride + first, *im = from.im + static_cast<Eigen::Index>(k) * from.stride + first;
  if (count >= lane_count()) return {hn::LoadU(Lanes(), re), hn::LoadU(Lanes(), im)};
  HWY_ALIGN double padded_re[8];
  HWY_ALIGN double padded_im[8];
  for (int lane = 0; lane < lane_count(); ++lane) {
    padded_re[lane] = re[lane < count ? lane : count - 1];
    padded_im[lane] = im[lane < count ? lane : count - 1];
  }
  return {hn::Load(Lanes(), padded_re), hn::Load(Lanes(), padded_im)};
}

/// What is given at `count` frequencies from `first` on.
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
  for (std::size_t k = 0; k < plan.free.size(); ++k) p.free[k] = all(plan.free[k].scale) * read(batch.free, plan.free[k].number, first, count);
  for (std::size_t i = 0; plan.given_load && i < plan.rows; ++i) p.load[i] = all(plan.scale[i]) * read(batch.load, plan.given_row[i], first, count);
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

void write_pass(const BlockPlan& plan, const BlockBatch& batch, Eigen::Index first, int count, const Pass& p, const Pack& error) {
  for (std::size_t i = 0; i < plan.rows; ++i) {
    const Eigen::Index to = static_cast<Eigen::Index>(plan.given_row[i]) * batch.response.stride + first;
    const Pack scale = all(plan.scale[i]);
    write(hn::Mul(scale, p.q[i].re), count, batch.response.re + to);
    write(hn::Mul(scale, p.q[i].im), count, batch.response.im + to);
  }
  write(error, count, batch.backward_error + first);
}

int solve_blocks(const BlockPlan& plan, const BlockBatch& batch) {
  const Eigen::Index lanes = lane_count();
  BlockSolver solver(plan);
  int doubtful = 0;
  for (Eigen::Index first = 0; first < batch.count; first += passes * lanes) {
    int filled[passes], open = 0;
    Pack error[passes];
    for (int i = 0; i < passes; ++i) {
      filled[i] = static_cast<int>(std::clamp<Eigen::Index>(batch.count - first - i * lanes, 0, lanes));
      if (filled[i] > 0) read_pass(plan, batch, first + i * lanes, filled[i], solver.pass(i));
      else read_pass(plan, batch, first, filled[0], solver.pass(i));
    }
    solver.solve();
    for (int i = 0; i < passes; ++i) {
      error[i] = solver.seen_backward_error(i, batch.measure_all);
      const LaneMask present = hn::FirstN(Lanes(), static_cast<std::size_t>(filled[i]));
      open += static_cast<int>(hn::CountTrue(Lanes(), hn::AndNot(BlockSolver::certain(error[i]), present)));
    }
    if (open > 0) solver.refine(error);
    doubtful += open;
    for (int i = 0; i < passes; ++i)
      if (filled[i] > 0) write_pass(plan, batch, first + i * lanes, filled[i], solver.pass(i), error[i]);
  }
  return doubtful;
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "trivet/numerics/dispatch.h"

namespace trivet::numerics {

TRIVET_VARIANTS(solve_blocks);

BlockSweep::BlockSweep(const DynamicMatrices& matrices, const Load& load, const std::vector<FreeEntry>& free) {
  const Eigen::VectorXd d = unit_scale(matrices);
  const Load scaled_load = load.scaled(d);
  plan_ = block_plan(scaled(matrices, d), &scaled_load, d, free);
}

BlockSweep::BlockSweep(const DynamicMatrices& matrices, const std::vector<FreeEntry>& free) {
  const Eigen::VectorXd d = unit_scale(matrices);
  plan_ = block_plan(scaled(matrices, d), nullptr, d, free);
}

int BlockSweep::solve(const BlockBatch& batch) const { return TRIVET_DISPATCH(solve_blocks)(plan_, batch); }

int BlockSweep::solve(const double* omega, Eigen::Index count, Eigen::Ref<Eigen::MatrixXcd> response, Eigen::Ref<Eigen::VectorXd> backward_error) const {
  constexpr Eigen::Index chunk = 64;  // their planes stay in cache
  Eigen::ArrayXXd re(chunk, response.rows()), im(chunk, response.rows());
  int doubtful = 0;
  for (Eigen::Index first = 0; first < count; first += chunk) {
    const Eigen::Index filled = std::min(chunk, count - first);
    doubtful += solve({omega + first, filled, {}, {}, {re.data(), im.data(), chunk}, backward_error.data() + first});
    response.middleCols(first, filled).real() = re.topRows(filled).transpose();
    response.middleCols(first, filled).imag() = im.topRows(filled).transpose();
  }
  return doubtful;
}

}  // namespace trivet::numerics
#endif
