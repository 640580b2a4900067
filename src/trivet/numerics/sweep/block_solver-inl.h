// SPDX-License-Identifier: BSD-3-Clause
// Executes a block plan for some packs of frequencies: elimination and substitution. Include after hwy/foreach_target.h
// only.
#if defined(TRIVET_NUMERICS_BLOCK_SOLVER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_BLOCK_SOLVER_INL_H_
#undef TRIVET_NUMERICS_BLOCK_SOLVER_INL_H_
#else
#define TRIVET_NUMERICS_BLOCK_SOLVER_INL_H_
#endif

#include <algorithm>
#include <cassert>
#include <limits>
#include <new>

#include "trivet/foundation/index.h"
#include "trivet/numerics/sweep/block_kernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

/// Data of one pack of frequencies.
struct Pass {
  /// Uses uninitialised memory for `plan.packs()` packs.
  Pass(const BlockPlan& plan, double* memory) {
    const auto allocate = [&](std::size_t count) {
      auto* packs = new (memory) ComplexPack[count];
      memory += count * BlockPlan::pack;
      return packs;
    };
    factors = allocate(plan.factors), left = allocate(plan.widest), plain = allocate(plan.widest),
    residual = allocate(plan.rows);
    terms = allocate(plan.load.size()), free = allocate(plan.free.size()),
    load = allocate(plan.given_load ? plan.rows : 0);
  }

  ComplexPack *factors, *left, *plain, *residual, *terms, *free, *load;
  ComplexPack* q = nullptr;  ///< destination of the solution
  Frequencies at{};
  Pack smallest{};  ///< least |pivot|²
};

/// Solves groups of packs of frequencies, one after another in the same memory.
class BlockSolver {
 public:
  BlockSolver(const BlockPlan& plan, double* memory)
      : plan_(plan), passes_{Pass(plan, memory), Pass(plan, memory + plan.packs() * BlockPlan::pack)} {}

  [[nodiscard]] Pass& pass(int i) { return passes_[i]; }

  /// Writes the results to `q` of each pass.
  void solve() {
    for (Pass& p : passes_) {
      p.smallest = all(std::numeric_limits<double>::max());
      p.at.square = hn::Mul(p.at.omega, p.at.omega);
      set_load(p, p.q);
    }
    for (const BlockPlan::Column& column : plan_.columns) {
      // NOLINTNEXTLINE(bugprone-branch-clone): they differ in optimised builds
      if (column.size == body) eliminate<written_out>(column);
      else eliminate<0>(column);
    }
    substitute_back(passes_[0].q, passes_[1].q, false);
  }

  /// Replaces `residual` by Z⁻¹ times it.
  void solve_residual() {
    for (const Pass& p : passes_)
      for (const BlockPlan::Column& column : plan_.columns) substitute_again(column, p, p.residual);
    substitute_back(passes_[0].residual, passes_[1].residual, true);
  }

  /// Writes h in the rows of loaded columns only.
  void set_load(const Pass& p, ComplexPack* HWY_RESTRICT h) const {
    if (plan_.given_load) {
      std::copy_n(p.load, plan_.rows, h);
      return;
    }
    for (const BlockPlan::Column& column : plan_.columns)
      for (std::size_t i = column.row; column.loaded && i < column.row + to_size(column.size); ++i)
        h[i] = {all(0.0), all(0.0)};
    for (std::size_t t = 0; t < plan_.load.size(); ++t)
      for (const BlockPlan::LoadRow& row : plan_.load[t].rows)
        h[row.row] = add_product(h[row.row], p.terms[t], {all(row.value.real()), all(row.value.imag())});
  }

  void assemble_block(const BlockPlan::Block& b, const Pass& p, ComplexPack* to) const {
    const Given matrices = given(b);
    if (matrices.with_mass()) assemble_with_mass(b.entries(), matrices, p.at, to);
    else assemble(b.entries(), matrices, p.at, to);
    for (std::size_t k = b.free_first; k < b.free_end; ++k)
      to[plan_.free[k].entry] = to[plan_.free[k].entry] + p.free[k];
  }

 private:
  static constexpr int body = 6;
#ifdef NDEBUG
  static constexpr int written_out = body;  ///< compile-time number of coordinates
#else
  static constexpr int written_out = 0;  ///< the instrumented build keeps its loops: unrolling takes minutes to compile
#endif

  [[nodiscard]] const BlockPlan::Block& block(int number) const { return plan_.blocks[number]; }
  [[nodiscard]] Given given(const BlockPlan::Block& b) const { return {b, plan_.values.data()}; }

  template <int fixed>
  static HWY_INLINE int size_of(const BlockPlan::Column& column) {
    return fixed > 0 ? fixed : column.size;
  }

  template <int fixed>
  HWY_INLINE void eliminate(const BlockPlan::Column& column) {
    const BlockPlan::Block& diagonal = block(column.diagonal);
    assert(diagonal.diagonal && diagonal.kept && diagonal.rows == column.size && "pivots of every column are kept");
    if (column.first)
      for (const Pass& p : passes_) assemble_block(diagonal, p, p.factors + diagonal.place);
    factor<fixed>(column.size, passes_[0].factors + diagonal.place, passes_[1].factors + diagonal.place,
                  passes_[0].smallest, passes_[1].smallest);
    for (std::size_t k = column.below_first; k < column.below_end; ++k)
      for (const Pass& p : passes_) divide_below<fixed>(column, plan_.below[k], p);
    for (std::size_t k = column.update_first; k < column.update_end; ++k)
      for (const Pass& p : passes_) update<fixed>(plan_.updates[k], p);
    if (column.loaded)
      for (const Pass& p : passes_) substitute(size_of<fixed>(column), column, p, p.q);
  }

  /// Location of L of a block below while its column is processed.
  ComplexPack* left_of(const BlockPlan::Below& below, const Pass& p) const {
    const BlockPlan::Block& b = block(below.block);
    return b.kept ? p.factors + b.place : p.left + below.place;
  }

  template <int fixed>
  HWY_INLINE void divide_below(const BlockPlan::Column& column, const BlockPlan::Below& below, const Pass& p) const {
    const BlockPlan::Block& b = block(below.block);
    const ComplexPack* l = p.factors + block(column.diagonal).place;
    ComplexPack* a = left_of(below, p);
    const Given matrices = given(b);
    if (!b.kept && matrices.stiffness_and_damping()) {
      divide<fixed, true>(b.rows, b.columns, l, a, p.plain + below.place, matrices.K, matrices.B, p.at.omega);
      return;
    }
    if (!b.kept || below.first) assemble_block(b, p, a);
    divide<fixed, false>(b.rows, b.columns, l, a, p.plain + below.place, nullptr, nullptr, p.at.omega);
  }

  template <int fixed>
  HWY_INLINE void update(const BlockPlan::Update& u, const Pass& p) const {
    const BlockPlan::Block& target = block(u.target);
    assert(target.kept && "blocks that are updated have a place among the factors");
    const BlockPlan::Below& right = plan_.below[u.right];
    const int inner = block(right.block).columns;
    ComplexPack* a = p.factors + target.place;
    const ComplexPack *l = left_of(plan_.below[u.left], p), *plain = p.plain + right.place;
    const Given matrices = given(target);
    if (u.first && target.diagonal && matrices.with_mass() && !target.has_free()) {
      subtract_lower<fixed, true>(target.rows, inner, l, plain, a, matrices, p.at);
      return;
    }
    if (u.first) assemble_block(target, p, a);
    if (target.diagonal) subtract_lower<fixed, false>(target.rows, inner, l, plain, a, matrices, p.at);
    else subtract_full<fixed>(target.rows, target.columns, inner, l, plain, a, matrices, p.at);
  }

  /// Applies one column of D⁻¹L⁻¹ while it is eliminated.
  HWY_INLINE void substitute(int size, const BlockPlan::Column& column, const Pass& p, ComplexPack* h) const {
    const ComplexPack* l = p.factors + block(column.diagonal).place;
    forward(size, l, h + column.row);
    for (std::size_t k = column.below_first; k < column.below_end; ++k)
      forward_below(block(plan_.below[k].block).rows, size, left_of(plan_.below[k], p), h + column.row,
                    h + plan_.below[k].row);
    divide_by_pivots(size, l, h + column.row);
  }

  /// The same later, when only some blocks of L are kept: L_i y = A_i L⁻ᵀD⁻¹y.
  void substitute_again(const BlockPlan::Column& column, const Pass& p, ComplexPack* h) const {
    const ComplexPack* l = p.factors + block(column.diagonal).place;
    ComplexPack* x = h + column.row;
    forward(column.size, l, x);
    ComplexPack back[largest_kernel_block];
    for (int i = 0; i < column.size; ++i) back[i] = x[i];
    divide_by_pivots(column.size, l, back);
    backward(column.size, l, back);
    for (std::size_t k = column.below_first; k < column.below_end; ++k) {
      const BlockPlan::Block& b = block(plan_.below[k].block);
      if (b.kept) forward_below(b.rows, column.size, p.factors + b.place, x, h + plan_.below[k].row);
      else subtract_given(b.rows, column.size, given(b), p.at, back, h + plan_.below[k].row);
    }
    divide_by_pivots(column.size, l, x);
  }

  void substitute_back(ComplexPack* first, ComplexPack* second, bool all_loaded) const {
    ComplexPack* const x[passes] = {first, second};
    for (std::size_t j = plan_.columns.size(); j-- > 0;) {
      const BlockPlan::Column& column = plan_.columns[j];
      // NOLINTNEXTLINE(bugprone-branch-clone): they differ in optimised builds
      if (column.size == body) column_back<written_out>(column, x, all_loaded || column.loaded);
      else column_back<0>(column, x, all_loaded || column.loaded);
    }
  }

  /// Applies one column of L⁻ᵀ in all passes. For blocks that are not kept, Lᵀx = D⁻¹L⁻¹Aᵀx.
  template <int fixed>
  HWY_INLINE void column_back(const BlockPlan::Column& column, ComplexPack* const* x, bool loaded) const {
    const int size = size_of<fixed>(column);
    const std::size_t place = block(column.diagonal).place;
    Small sum;
    TRIVET_UNROLL for (int p = 0; p < passes; ++p) TRIVET_UNROLL for (int i = 0; i < size; ++i)
        sum.x[p][i] = {all(0.0), all(0.0)};
    const bool pulled = pull(size, column, x, sum);
    TRIVET_UNROLL for (int p = 0; p < passes; ++p) {
      const ComplexPack* l = passes_[p].factors + place;
      if (pulled) {
        forward(size, l, sum.x[p]);
        divide_by_pivots(size, l, sum.x[p]);
      }
      if (loaded) TRIVET_UNROLL for (int i = 0; i < size; ++i) sum.x[p][i] = x[p][column.row + i] + sum.x[p][i];
      for (std::size_t k = column.below_first; k < column.below_end; ++k) {
        const BlockPlan::Block& b = block(plan_.below[k].block);
        if (b.kept) backward_below(b.rows, size, passes_[p].factors + b.place, x[p] + plan_.below[k].row, sum.x[p]);
      }
      backward(size, l, sum.x[p]);
      TRIVET_UNROLL for (int i = 0; i < size; ++i) x[p][column.row + i] = sum.x[p][i];
    }
  }

  /// sum −= Aᵀx over the blocks below that are not kept. Returns whether there are any.
  HWY_INLINE bool pull(int size, const BlockPlan::Column& column, ComplexPack* const* x, Small& sum) const {
    const Pack one[passes] = {all(-1.0), all(-1.0)},
               omega[passes] = {hn::Neg(passes_[0].at.omega), hn::Neg(passes_[1].at.omega)};
    bool any = false;
    for (std::size_t k = column.below_first; k < column.below_end; ++k) {
      const BlockPlan::Block& b = block(plan_.below[k].block);
      if (b.kept) continue;
      any = true;
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
    return any;
  }

  const BlockPlan& plan_;
  Pass passes_[passes];
};

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
