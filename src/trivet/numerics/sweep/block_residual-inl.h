// SPDX-License-Identifier: BSD-3-Clause
// Backward errors of the solutions of a block plan, and refinement. Include after hwy/foreach_target.h only.
#if defined(TRIVET_NUMERICS_BLOCK_RESIDUAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_BLOCK_RESIDUAL_INL_H_
#undef TRIVET_NUMERICS_BLOCK_RESIDUAL_INL_H_
#else
#define TRIVET_NUMERICS_BLOCK_RESIDUAL_INL_H_
#endif

#include <cassert>

#include "trivet/numerics/sweep/block_solver-inl.h"
#include "trivet/numerics/sweep/frequency_sweep.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

inline Pack row_norm(const BlockPlan& plan, std::size_t row, const Pass& p) {
  Pack sum = all(0.0);
  for (std::size_t k = plan.entry_first[row]; k < plan.entry_first[row + 1]; ++k) {
    const BlockPlan::Entry& e = plan.entries[k];
    ComplexPack z{hn::NegMulAdd(p.at.square, all(e.A), all(e.K)), hn::MulAdd(p.at.omega, all(e.B), all(e.loss))};
    if (e.free >= 0) z = z + p.free[e.free];
    sum = hn::Add(sum, one_norm(z));
  }
  return sum;
}

/// Lower bound of ‖Z‖∞.
inline Pack norm_of_large_rows(const BlockPlan& plan, const Pass& p) {
  Pack norm = all(0.0);
  for (const std::size_t i : plan.large_rows) norm = hn::Max(norm, row_norm(plan, i, p));
  return norm;
}

/// The error, or ∞ if a pivot is only round-off: then the residual is small, but the solution is meaningless.
inline Pack refused_pivots(const BlockPlan& plan, const Pass& p, const Pack& error, const Pack& norm) {
  const double negligible = 16 * static_cast<double>(plan.rows) * std::numeric_limits<double>::epsilon();
  const Pack limit = hn::Mul(all(negligible), norm);
  return hn::IfThenElse(hn::Gt(p.smallest, hn::Mul(limit, limit)), error, all(std::numeric_limits<double>::infinity()));
}

/// Backward error along one direction: |wᵀ(Zq − h)| divided by lower bounds of ‖Z‖∞ and ‖q‖∞.
inline Pack projected_backward_error(const BlockPlan& plan, const Pass& p) {
  ComplexPack projected{all(0.0), all(0.0)};
  Pack square = all(0.0);
  for (std::size_t i = 0; i < plan.rows; ++i) {
    const ComplexPack z{hn::NegMulAdd(p.at.square, all(plan.weighted_A[i]), all(plan.weighted_K[i])),
                        hn::MulAdd(p.at.omega, all(plan.weighted_B[i]), all(plan.weighted_loss[i]))};
    projected = add_product(projected, z, p.q[i]);
    square = hn::Max(square, squared_modulus(p.q[i]));
  }
  for (std::size_t k = 0; k < plan.free.size(); ++k) {
    const BlockPlan::Free& entry = plan.free[k];
    ComplexPack moved = all(plan.weight[entry.row]) * p.q[entry.column];
    if (entry.row != entry.column) moved = moved + all(plan.weight[entry.column]) * p.q[entry.row];
    projected = add_product(projected, p.free[k], moved);
  }
  for (std::size_t i = 0; plan.given_load && i < plan.rows; ++i)
    projected = subtract_product(projected, all(plan.weight[i]), p.load[i]);
  for (std::size_t t = 0; t < plan.load.size(); ++t)
    projected =
        subtract_product(projected, p.terms[t], {all(plan.load[t].weighted.real()), all(plan.load[t].weighted.imag())});
  const Pack norm = norm_of_large_rows(plan, p);
  return refused_pivots(plan, p, hn::Div(one_norm(projected), hn::Mul(norm, hn::Sqrt(square))), norm);
}

/// Leaves h − Zq in `residual`. Returns ‖h‖∞.
inline Pack set_residual(const BlockPlan& plan, const BlockSolver& solver, const Pass& p) {
  for (std::size_t i = 0; i < plan.rows; ++i) p.residual[i] = {all(0.0), all(0.0)};
  solver.set_load(p, p.residual);
  Pack load = all(0.0);
  for (std::size_t i = 0; i < plan.rows; ++i) load = hn::Max(load, one_norm(p.residual[i]));
  ComplexPack z[largest_kernel_block * largest_kernel_block];
  for (const BlockPlan::Column& column : plan.columns) {
    const ComplexPack* x = p.q + column.row;
    ComplexPack* r = p.residual + column.row;
    solver.assemble_block(plan.blocks[column.diagonal], p, z);
    subtract_symmetric(column.size, z, x, r);
    for (std::size_t k = column.below_first; k < column.below_end; ++k) {
      const BlockPlan::Below& below = plan.below[k];
      const BlockPlan::Block& b = plan.blocks[below.block];
      if (b.is_filled()) continue;
      assert(b.entries() <= largest_kernel_block * largest_kernel_block);
      solver.assemble_block(b, p, z);
      forward_below(b.rows, b.columns, z, x, p.residual + below.row);
      backward_below(b.rows, b.columns, z, p.q + below.row, r);
    }
  }
  return load;
}

/// Backward error as in `SweepResult`, with |re| + |im| for the modulus; ‖Z‖∞ from its large rows, or from all rows if
/// the error is not accepted.
inline Pack backward_error(const BlockPlan& plan, const BlockSolver& solver, const Pass& p) {
  const Pack load = set_residual(plan, solver, p), zero = all(0.0);
  Pack worst = zero, size = zero, nothing = zero;
  for (std::size_t i = 0; i < plan.rows; ++i) {
    const Pack r = one_norm(p.residual[i]), q = one_norm(p.q[i]);
    worst = hn::Max(worst, r);
    size = hn::Max(size, q);
    nothing = hn::MulAdd(zero, hn::Add(r, q), nothing);  // a maximum could hide NaN and ∞
  }
  worst = hn::Add(worst, nothing);
  Pack norm = norm_of_large_rows(plan, p);
  const auto error = [&]() TRIVET_LANES {
    return hn::IfThenZeroElse(hn::Eq(worst, zero), hn::Div(worst, hn::MulAdd(norm, size, load)));
  };
  const LaneMask accepted = hn::Le(error(), all(accepted_backward_error));
  if (!hn::AllTrue(Lanes(), accepted)) {
    Pack full = norm;
    for (std::size_t i = 0; i < plan.rows; ++i) full = hn::Max(full, row_norm(plan, i, p));
    norm = hn::IfThenElse(accepted, norm, full);
  }
  return refused_pivots(plan, p, error(), norm);
}

/// Lanes that do not need the full residual; a factor of 4, because one direction may show only a part of it.
inline LaneMask certain(const Pack& error) { return hn::Le(error, all(accepted_backward_error / 4)); }

/// Computes the full backward errors of lanes that are not certain, and refines them until they are accepted, in a few
/// steps at most.
inline void refine(const BlockPlan& plan, BlockSolver& solver, Pack* error) {
  constexpr int most_steps = 3;
  LaneMask doubtful[passes], bad[passes];
  for (int i = 0; i < passes; ++i) doubtful[i] = hn::Not(certain(error[i]));
  for (int step = 0; step <= most_steps; ++step) {
    for (int i = 0; i < passes; ++i) {
      const Pack measured = backward_error(plan, solver, solver.pass(i));
      error[i] = hn::IfThenElse(doubtful[i], measured, error[i]);
      bad[i] = hn::AndNot(hn::Le(measured, all(accepted_backward_error)), doubtful[i]);
    }
    if (step == most_steps || (hn::AllFalse(Lanes(), bad[0]) && hn::AllFalse(Lanes(), bad[1]))) break;
    solver.solve_residual();
    for (int i = 0; i < passes; ++i) {
      const Pass& p = solver.pass(i);
      for (std::size_t k = 0; k < plan.rows; ++k) {
        const ComplexPack better = p.q[k] + p.residual[k];
        p.q[k] = {hn::IfThenElse(bad[i], better.re, p.q[k].re), hn::IfThenElse(bad[i], better.im, p.q[k].im)};
      }
    }
  }
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
