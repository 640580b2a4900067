// SPDX-License-Identifier: BSD-3-Clause
// Steps of LDLᵀ by blocks, one frequency per lane. Sizes are arguments: if they are constants, the loops unroll and a
// block of six by six stays in registers. Include after hwy/foreach_target.h only.
#if defined(TRIVET_NUMERICS_BLOCK_KERNELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_BLOCK_KERNELS_INL_H_
#undef TRIVET_NUMERICS_BLOCK_KERNELS_INL_H_
#else
#define TRIVET_NUMERICS_BLOCK_KERNELS_INL_H_
#endif

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "trivet/numerics/lanes/lanes-inl.h"
#include "trivet/numerics/sweep/block_plan.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

struct Frequencies {
  Pack omega, square;
};

/// Matrices of one block; null if it has none.
struct Given {
  const double *K = nullptr, *loss = nullptr, *B = nullptr, *A = nullptr;

  Given(const BlockPlan::Block& block, const double* values) {
    const double* next = values + block.values;
    const auto next_block = [&](bool has) { return has ? std::exchange(next, next + block.entries()) : nullptr; };
    K = next_block(block.has_K), loss = next_block(block.has_loss), B = next_block(block.has_B),
    A = next_block(block.has_A);
  }
  [[nodiscard]] bool stiffness_and_damping() const {
    return K != nullptr && B != nullptr && loss == nullptr && A == nullptr;
  }
  [[nodiscard]] bool with_mass() const { return K != nullptr && B != nullptr && A != nullptr && loss == nullptr; }
};

/// K − ω²A + i(K_loss + ωB) of one block.
HWY_INLINE void assemble(int entries, const Given& given, const Frequencies& at, ComplexPack* HWY_RESTRICT z) {
  for (int k = 0; k < entries; ++k) {
    Pack re = given.K != nullptr ? all(given.K[k]) : all(0.0),
         im = given.loss != nullptr ? all(given.loss[k]) : all(0.0);
    if (given.A != nullptr) re = hn::NegMulAdd(at.square, all(given.A[k]), re);
    if (given.B != nullptr) im = hn::MulAdd(at.omega, all(given.B[k]), im);
    z[k] = {re, im};
  }
}

HWY_INLINE void assemble_with_mass(int entries, const Given& given, const Frequencies& at,
                                   ComplexPack* HWY_RESTRICT z) {
  for (int k = 0; k < entries; ++k)
    z[k] = {hn::NegMulAdd(at.square, all(given.A[k]), all(given.K[k])), hn::Mul(at.omega, all(given.B[k]))};
}

/// Two packs of frequencies are solved together: while one waits for a pivot, the other is computed.
inline constexpr int passes = BlockPlan::passes;

/// LDLᵀ of packed lower triangles in place, with the inverse pivots on the diagonal. `smallest` is the least |pivot|²
/// so far.
template <int fixed>
HWY_NOINLINE void factor(int size, ComplexPack* HWY_RESTRICT first, ComplexPack* HWY_RESTRICT second,
                         Pack& first_smallest, Pack& second_smallest) {
  const int n = fixed > 0 ? fixed : std::min(size, largest_kernel_block);
  assert(size > 0 && size <= largest_kernel_block && (fixed == 0 || size == fixed));
  ComplexPack* const a[passes] = {first, second};
  Pack* const smallest[passes] = {&first_smallest, &second_smallest};
  constexpr int most = largest_kernel_block * (largest_kernel_block + 1) / 2;
  ComplexPack plain[passes][most], l[passes][most];
  TRIVET_UNROLL for (int j = 0; j < n; ++j) {
    ComplexPack d[passes];
    TRIVET_UNROLL for (int p = 0; p < passes; ++p) {
      ComplexPack pivot = a[p][packed(j, j)];
      TRIVET_UNROLL for (int k = 0; k < j; ++k) pivot =
          subtract_product(pivot, l[p][packed(j, k)], plain[p][packed(j, k)]);
      const Pack square = squared_modulus(pivot);
      *smallest[p] = hn::Min(*smallest[p], square);
      const Pack over = hn::Div(all(1.0), square);
      d[p] = {hn::Mul(pivot.re, over), hn::Neg(hn::Mul(pivot.im, over))};
      a[p][packed(j, j)] = d[p];
    }
    TRIVET_UNROLL for (int i = j + 1; i < n; ++i) TRIVET_UNROLL for (int p = 0; p < passes; ++p) {
      ComplexPack x = a[p][packed(i, j)];
      TRIVET_UNROLL for (int k = 0; k < j; ++k) x = subtract_product(x, l[p][packed(i, k)], plain[p][packed(j, k)]);
      plain[p][packed(i, j)] = x;
      l[p][packed(i, j)] = x * d[p];
      a[p][packed(i, j)] = l[p][packed(i, j)];
    }
  }
}

#if HWY_CAP_GE512
inline constexpr int rows_at_once = 2, tile = 3;  // fits into 32 registers
#else
inline constexpr int rows_at_once = 1, tile = 2;
#endif

/// Some rows of a block below: `plain` = A L⁻ᵀ, and A ← plain D⁻¹. A separate function: inlined in a loop, it would
/// need more registers than there are for all of L. `fixed` is the number of columns unless it is 0. Numbers are read
/// one by one: g++ 12 copies a ComplexPack of 64 bytes in quarters through the stack and waits for it, which made AVX2
/// six times slower.
template <int fixed, int rows, bool given>
HWY_NOINLINE void divide_rows(int size, const ComplexPack* HWY_RESTRICT l, ComplexPack* HWY_RESTRICT a,
                              ComplexPack* HWY_RESTRICT plain, const double* K, const double* B, const Pack& omega) {
  const int columns = fixed > 0 ? fixed : std::min(size, largest_kernel_block);
  assert(size > 0 && size <= largest_kernel_block && (fixed == 0 || size == fixed));
  ComplexPack w[rows][largest_kernel_block];
  TRIVET_UNROLL for (int c = 0; c < columns; ++c) TRIVET_UNROLL for (int r = 0; r < rows; ++r) {
    const int k = r * columns + c;
    if constexpr (given) w[r][c] = {all(K[k]), hn::Mul(omega, all(B[k]))};
    else w[r][c] = {a[k].re, a[k].im};
  }
  TRIVET_UNROLL for (int k = 0; k < columns; ++k) {
    TRIVET_UNROLL for (int r = 0; r < rows; ++r) {
      plain[r * columns + k] = w[r][k];
      a[r * columns + k] = w[r][k] * l[packed(k, k)];
    }
    TRIVET_UNROLL for (int c = k + 1; c < columns; ++c) {
      const ComplexPack& factor = l[packed(c, k)];
      TRIVET_UNROLL for (int r = 0; r < rows; ++r) w[r][c] = subtract_product(w[r][c], w[r][k], factor);
    }
  }
}

template <int fixed, bool given>
HWY_INLINE void divide(int rows, int columns, const ComplexPack* HWY_RESTRICT l, ComplexPack* HWY_RESTRICT a,
                       ComplexPack* HWY_RESTRICT plain, const double* K, const double* B, const Pack& omega) {
  int r = 0;
  const auto some = [&]<int count>(std::integral_constant<int, count>) HWY_ATTR {
    const int k = r * columns;
    divide_rows<fixed, count, given>(columns, l, a + k, plain + k, given ? K + k : nullptr, given ? B + k : nullptr,
                                     omega);
    r += count;
  };
  // NOLINTNEXTLINE(bugprone-infinite-loop): `some` increases r
  while (r + rows_at_once <= rows) some(std::integral_constant<int, rows_at_once>());
  // NOLINTNEXTLINE(bugprone-infinite-loop)
  while (r < rows) some(std::integral_constant<int, 1>());
}

/// Start of the lines of a target: `line` apart, or with a distance that grows by one per line in a packed triangle.
struct Lines {
  int line = 0;
  bool growing = false;
  [[nodiscard]] HWY_INLINE int at(int r) const { return r * line + (growing ? r * (r - 1) / 2 : 0); }
};

/// A tile of target −= left rightᵀ, or of its lower triangle. With `given`, the target starts as K − ω²A + iωB.
template <int fixed, int high, int wide, bool lower, bool given>
HWY_NOINLINE void subtract_tile(int size, const ComplexPack* HWY_RESTRICT left, const ComplexPack* HWY_RESTRICT right,
                                ComplexPack* HWY_RESTRICT target, Lines lines, const Given& matrices, int offset,
                                const Frequencies& at) {
  const int inner = fixed > 0 ? fixed : size;
  ComplexPack sum[high][wide];
  TRIVET_UNROLL for (int r = 0; r < high; ++r) TRIVET_UNROLL for (int s = 0; s < (lower ? r + 1 : wide); ++s) {
    const int k = offset + lines.at(r) + s;
    if constexpr (given)
      sum[r][s] = {hn::NegMulAdd(at.square, all(matrices.A[k]), all(matrices.K[k])),
                   hn::Mul(at.omega, all(matrices.B[k]))};
    else sum[r][s] = target[k];
  }
  TRIVET_UNROLL for (int c = 0; c < inner; ++c) TRIVET_UNROLL for (int s = 0; s < wide; ++s) {
    const ComplexPack factor = right[s * inner + c];
    TRIVET_UNROLL for (int r = lower ? s : 0; r < high; ++r) sum[r][s] =
        subtract_product(sum[r][s], left[r * inner + c], factor);
  }
  TRIVET_UNROLL for (int r = 0; r < high; ++r) TRIVET_UNROLL for (int s = 0; s < (lower ? r + 1 : wide); ++s)
      target[offset + lines.at(r) + s] = sum[r][s];
}

/// Start of a row of a matrix that is stored by rows.
HWY_INLINE const ComplexPack* row_of(const ComplexPack* matrix, int row, int length) {
  return matrix + static_cast<std::ptrdiff_t>(row) * length;
}

/// target −= left rightᵀ, rows × columns.
template <int fixed>
HWY_INLINE void subtract_full(int rows, int columns, int inner, const ComplexPack* HWY_RESTRICT left,
                              const ComplexPack* HWY_RESTRICT right, ComplexPack* HWY_RESTRICT target,
                              const Given& matrices, const Frequencies& at) {
  int r = 0;
  for (; r + tile <= rows; r += tile) {
    int s = 0;
    for (; s + tile <= columns; s += tile)
      subtract_tile<fixed, tile, tile, false, false>(inner, row_of(left, r, inner), row_of(right, s, inner), target,
                                                     {columns}, matrices, r * columns + s, at);
    for (; s < columns; ++s)
      subtract_tile<fixed, tile, 1, false, false>(inner, row_of(left, r, inner), row_of(right, s, inner), target,
                                                  {columns}, matrices, r * columns + s, at);
  }
  for (; r < rows; ++r)
    for (int s = 0; s < columns; ++s)
      subtract_tile<fixed, 1, 1, false, false>(inner, row_of(left, r, inner), row_of(right, s, inner), target,
                                               {columns}, matrices, r * columns + s, at);
}

/// The packed lower triangle of target −= left rightᵀ.
template <int fixed, bool given>
HWY_INLINE void subtract_lower(int rows, int inner, const ComplexPack* HWY_RESTRICT left,
                               const ComplexPack* HWY_RESTRICT right, ComplexPack* HWY_RESTRICT target,
                               const Given& matrices, const Frequencies& at) {
  int r = 0;
  for (; r + tile <= rows; r += tile) {
    for (int s = 0; s < r; s += tile)
      subtract_tile<fixed, tile, tile, false, given>(inner, row_of(left, r, inner), row_of(right, s, inner), target,
                                                     {r + 1, true}, matrices, packed(r, s), at);
    subtract_tile<fixed, tile, tile, true, given>(inner, row_of(left, r, inner), row_of(right, r, inner), target,
                                                  {r + 1, true}, matrices, packed(r, r), at);
  }
  for (; r < rows; ++r)
    for (int s = 0; s <= r; ++s)
      subtract_tile<fixed, 1, 1, false, given>(inner, row_of(left, r, inner), row_of(right, s, inner), target, {},
                                               matrices, packed(r, s), at);
}

/// x ← L⁻¹x
HWY_INLINE void forward(int n, const ComplexPack* HWY_RESTRICT l, ComplexPack* HWY_RESTRICT x) {
  ComplexPack y[largest_kernel_block];
  TRIVET_UNROLL for (int i = 0; i < n; ++i) {
    y[i] = x[i];
    TRIVET_UNROLL for (int k = 0; k < i; ++k) y[i] = subtract_product(y[i], l[packed(i, k)], y[k]);
    x[i] = y[i];
  }
}

/// below −= l x
HWY_INLINE void forward_below(int rows, int columns, const ComplexPack* HWY_RESTRICT l,
                              const ComplexPack* HWY_RESTRICT x, ComplexPack* HWY_RESTRICT below) {
  for (int r = 0; r < rows; ++r) {
    ComplexPack sum = below[r];
    TRIVET_UNROLL for (int c = 0; c < columns; ++c) sum = subtract_product(sum, l[r * columns + c], x[c]);
    below[r] = sum;
  }
}

/// target −= z x for a symmetric z in a packed lower triangle.
HWY_INLINE void subtract_symmetric(int n, const ComplexPack* HWY_RESTRICT z, const ComplexPack* HWY_RESTRICT x,
                                   ComplexPack* HWY_RESTRICT target) {
  for (int r = 0; r < n; ++r) {
    ComplexPack sum = target[r];
    for (int c = 0; c < n; ++c) sum = subtract_product(sum, z[packed_of(r, c)], x[c]);
    target[r] = sum;
  }
}

/// sum −= lᵀ below
HWY_INLINE void backward_below(int rows, int columns, const ComplexPack* HWY_RESTRICT l,
                               const ComplexPack* HWY_RESTRICT below, ComplexPack* HWY_RESTRICT sum) {
  for (int r = 0; r < rows; ++r) {
    const ComplexPack x = below[r];
    TRIVET_UNROLL for (int c = 0; c < columns; ++c) sum[c] = subtract_product(sum[c], l[r * columns + c], x);
  }
}

/// sum + M x for a real entry of M, or sum + iM x.
template <bool imaginary>
HWY_INLINE ComplexPack add_real(const ComplexPack& sum, double entry, const ComplexPack& x) {
  const Pack m = all(entry);
  if constexpr (imaginary) return {hn::NegMulAdd(m, x.im, sum.re), hn::MulAdd(m, x.re, sum.im)};
  else return {hn::MulAdd(m, x.re, sum.re), hn::MulAdd(m, x.im, sum.im)};
}

/// One small vector for each pass.
struct Small {
  ComplexPack x[passes][largest_kernel_block];
};

/// sum + Mᵀ(by x), M rows × columns.
template <bool imaginary>
HWY_INLINE void add_transposed(int rows, int columns, const double* M, const Pack* by, const ComplexPack* const* x,
                               Small& sum) {
  for (int r = 0; r < rows; ++r) {
    ComplexPack v[passes];
    TRIVET_UNROLL for (int p = 0; p < passes; ++p) v[p] = by[p] * x[p][r];
    TRIVET_UNROLL for (int c = 0; c < columns; ++c) TRIVET_UNROLL for (int p = 0; p < passes; ++p) sum.x[p][c] =
        add_real<imaginary>(sum.x[p][c], M[r * columns + c], v[p]);
  }
}

/// sum − M(by x), M rows × columns.
template <bool imaginary>
HWY_INLINE void subtract_real(int rows, int columns, const double* M, const Pack& by, const ComplexPack* HWY_RESTRICT x,
                              ComplexPack* HWY_RESTRICT sum) {
  if (M == nullptr) return;
  const Pack minus = hn::Neg(by);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) sum[r] = add_real<imaginary>(sum[r], M[r * columns + c], minus * x[c]);
}

/// sum − Z x for a given block, rows × columns.
HWY_INLINE void subtract_given(int rows, int columns, const Given& given, const Frequencies& at,
                               const ComplexPack* HWY_RESTRICT x, ComplexPack* HWY_RESTRICT sum) {
  subtract_real<false>(rows, columns, given.K, all(1.0), x, sum);
  subtract_real<true>(rows, columns, given.B, at.omega, x, sum);
  subtract_real<true>(rows, columns, given.loss, all(1.0), x, sum);
  subtract_real<false>(rows, columns, given.A, hn::Neg(at.square), x, sum);
}

/// x ← D⁻¹x
HWY_INLINE void divide_by_pivots(int n, const ComplexPack* HWY_RESTRICT l, ComplexPack* HWY_RESTRICT x) {
  TRIVET_UNROLL for (int i = 0; i < n; ++i) x[i] = x[i] * l[packed(i, i)];
}

/// x ← L⁻ᵀx
HWY_INLINE void backward(int n, const ComplexPack* HWY_RESTRICT l, ComplexPack* HWY_RESTRICT x) {
  TRIVET_UNROLL for (int i = n - 1; i > 0; --i) TRIVET_UNROLL for (int k = 0; k < i; ++k) x[k] =
      subtract_product(x[k], l[packed(i, k)], x[i]);
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
