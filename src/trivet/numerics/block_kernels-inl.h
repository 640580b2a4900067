// SPDX-License-Identifier: BSD-3-Clause
// Steps of LDLᵀ by blocks, one frequency per lane. Sizes are arguments: where they are constants the loops unroll, and a block of six by six
// stays in registers. Include after hwy/foreach_target.h only.
#if defined(TRIVET_NUMERICS_BLOCK_KERNELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_BLOCK_KERNELS_INL_H_
#undef TRIVET_NUMERICS_BLOCK_KERNELS_INL_H_
#else
#define TRIVET_NUMERICS_BLOCK_KERNELS_INL_H_
#endif

#include "trivet/numerics/block_plan.h"
#include "trivet/numerics/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

inline constexpr int largest_kernel_block = 8;

struct Frequencies {
  Pack omega, square;
};

/// K − ω²A + i(K_loss + ωB) of one block.
HWY_INLINE void assemble(int entries, const BlockPlan::Block& block, const double* values, const Frequencies& at, ComplexPack* HWY_RESTRICT z) {
  const double* K = values + block.values;
  const double* loss = K + (block.has_K ? entries : 0);
  const double* B = loss + (block.has_loss ? entries : 0);
  const double* A = B + (block.has_B ? entries : 0);
  if (block.has_K && block.has_A)
    for (int k = 0; k < entries; ++k) z[k].re = hn::NegMulAdd(at.square, all(A[k]), all(K[k]));
  else if (block.has_K)
    for (int k = 0; k < entries; ++k) z[k].re = all(K[k]);
  else if (block.has_A)
    for (int k = 0; k < entries; ++k) z[k].re = hn::Neg(hn::Mul(at.square, all(A[k])));
  else
    for (int k = 0; k < entries; ++k) z[k].re = all(0.0);
  if (block.has_B && block.has_loss)
    for (int k = 0; k < entries; ++k) z[k].im = hn::MulAdd(at.omega, all(B[k]), all(loss[k]));
  else if (block.has_B)
    for (int k = 0; k < entries; ++k) z[k].im = hn::Mul(at.omega, all(B[k]));
  else if (block.has_loss)
    for (int k = 0; k < entries; ++k) z[k].im = all(loss[k]);
  else
    for (int k = 0; k < entries; ++k) z[k].im = all(0.0);
}

/// LDLᵀ of a packed lower triangle in place, the inverses of the pivots on its diagonal. `smallest` is the least |pivot|² so far.
HWY_INLINE void factor(int n, ComplexPack* HWY_RESTRICT a, Pack& smallest) {
  ComplexPack plain[largest_kernel_block * (largest_kernel_block + 1) / 2], l[largest_kernel_block * (largest_kernel_block + 1) / 2];
#pragma GCC unroll 8
  for (int j = 0; j < n; ++j) {
    ComplexPack pivot = a[packed(j, j)];
#pragma GCC unroll 8
    for (int k = 0; k < j; ++k) pivot = subtract_product(pivot, l[packed(j, k)], plain[packed(j, k)]);
    const Pack size = squared_modulus(pivot);
    smallest = hn::Min(smallest, size);
    const Pack over = hn::Div(all(1.0), size);
    const ComplexPack d{hn::Mul(pivot.re, over), hn::Neg(hn::Mul(pivot.im, over))};
    a[packed(j, j)] = d;
#pragma GCC unroll 8
    for (int i = j + 1; i < n; ++i) {
      ComplexPack x = a[packed(i, j)];
#pragma GCC unroll 8
      for (int k = 0; k < j; ++k) x = subtract_product(x, l[packed(i, k)], plain[packed(j, k)]);
      plain[packed(i, j)] = x;
      l[packed(i, j)] = x * d;
      a[packed(i, j)] = l[packed(i, j)];
    }
  }
}

/// A block below: `plain` = A L⁻ᵀ, and A ← plain D⁻¹.
template <int group>
HWY_INLINE void divide_rows(int columns, const ComplexPack* HWY_RESTRICT l, ComplexPack* HWY_RESTRICT a, ComplexPack* HWY_RESTRICT plain) {
  ComplexPack w[group][largest_kernel_block];
#pragma GCC unroll 8
  for (int c = 0; c < columns; ++c) {
#pragma GCC unroll 8
    for (int r = 0; r < group; ++r) w[r][c] = a[r * columns + c];
#pragma GCC unroll 8
    for (int k = 0; k < c; ++k) {
      const ComplexPack factor = l[packed(c, k)];
#pragma GCC unroll 8
      for (int r = 0; r < group; ++r) w[r][c] = subtract_product(w[r][c], w[r][k], factor);
    }
#pragma GCC unroll 8
    for (int r = 0; r < group; ++r) {
      plain[r * columns + c] = w[r][c];
      a[r * columns + c] = w[r][c] * l[packed(c, c)];
    }
  }
}

HWY_INLINE void divide(int rows, int columns, const ComplexPack* HWY_RESTRICT l, ComplexPack* HWY_RESTRICT a, ComplexPack* HWY_RESTRICT plain) {
  int r = 0;
  for (; r + 2 <= rows; r += 2) divide_rows<2>(columns, l, a + r * columns, plain + r * columns);
  for (; r < rows; ++r) divide_rows<1>(columns, l, a + r * columns, plain + r * columns);
}

/// A tile of target −= left rightᵀ. `lower`: only its lower triangle.
template <int high, int wide>
HWY_INLINE void subtract_tile(bool lower, int inner, const ComplexPack* HWY_RESTRICT left, const ComplexPack* HWY_RESTRICT right, ComplexPack* const* target) {
  ComplexPack sum[high][wide];
#pragma GCC unroll 4
  for (int r = 0; r < high; ++r)
#pragma GCC unroll 4
    for (int s = 0; s < wide; ++s)
      if (!lower || s <= r) sum[r][s] = target[r][s];
#pragma GCC unroll 8
  for (int c = 0; c < inner; ++c)
#pragma GCC unroll 4
    for (int s = 0; s < wide; ++s) {
      const ComplexPack factor = right[s * inner + c];
#pragma GCC unroll 4
      for (int r = 0; r < high; ++r)
        if (!lower || s <= r) sum[r][s] = subtract_product(sum[r][s], left[r * inner + c], factor);
    }
#pragma GCC unroll 4
  for (int r = 0; r < high; ++r)
#pragma GCC unroll 4
    for (int s = 0; s < wide; ++s)
      if (!lower || s <= r) target[r][s] = sum[r][s];
}

/// target −= left rightᵀ, target a full block (rows × columns) or the packed lower triangle of one (rows = columns).
HWY_INLINE void subtract(bool diagonal, int rows, int columns, int inner, const ComplexPack* HWY_RESTRICT left, const ComplexPack* HWY_RESTRICT right,
                         ComplexPack* HWY_RESTRICT target) {
  constexpr int tile = 3;
  int r = 0;
  for (; r + tile <= rows; r += tile) {
    ComplexPack* lines[tile];
    int s = 0;
    for (; s + tile <= (diagonal ? r : columns); s += tile) {
      for (int k = 0; k < tile; ++k) lines[k] = target + (diagonal ? packed(r + k, s) : (r + k) * columns + s);
      subtract_tile<tile, tile>(false, inner, left + r * inner, right + s * inner, lines);
    }
    if (diagonal) {
      for (int k = 0; k < tile; ++k) lines[k] = target + packed(r + k, s);
      subtract_tile<tile, tile>(true, inner, left + r * inner, right + s * inner, lines);
    } else {
      for (; s < columns; ++s) {
        for (int k = 0; k < tile; ++k) lines[k] = target + (r + k) * columns + s;
        subtract_tile<tile, 1>(false, inner, left + r * inner, right + s * inner, lines);
      }
    }
  }
  for (; r < rows; ++r)
    for (int s = 0; s < (diagonal ? r + 1 : columns); ++s) {
      ComplexPack* line = target + (diagonal ? packed(r, s) : r * columns + s);
      subtract_tile<1, 1>(false, inner, left + r * inner, right + s * inner, &line);
    }
}

/// x ← L⁻¹x
HWY_INLINE void forward(int n, const ComplexPack* HWY_RESTRICT l, ComplexPack* HWY_RESTRICT x) {
  ComplexPack y[largest_kernel_block];
#pragma GCC unroll 8
  for (int i = 0; i < n; ++i) {
    y[i] = x[i];
#pragma GCC unroll 8
    for (int k = 0; k < i; ++k) y[i] = subtract_product(y[i], l[packed(i, k)], y[k]);
    x[i] = y[i];
  }
}

/// below −= l x
HWY_INLINE void forward_below(int rows, int columns, const ComplexPack* HWY_RESTRICT l, const ComplexPack* HWY_RESTRICT x, ComplexPack* HWY_RESTRICT below) {
  for (int r = 0; r < rows; ++r) {
    ComplexPack sum = below[r];
#pragma GCC unroll 8
    for (int c = 0; c < columns; ++c) sum = subtract_product(sum, l[r * columns + c], x[c]);
    below[r] = sum;
  }
}

/// sum −= lᵀ below
HWY_INLINE void backward_below(int rows, int columns, const ComplexPack* HWY_RESTRICT l, const ComplexPack* HWY_RESTRICT below, ComplexPack* HWY_RESTRICT sum) {
  for (int r = 0; r < rows; ++r) {
    const ComplexPack x = below[r];
#pragma GCC unroll 8
    for (int c = 0; c < columns; ++c) sum[c] = subtract_product(sum[c], l[r * columns + c], x);
  }
}

/// x ← L⁻ᵀx
HWY_INLINE void backward(int n, const ComplexPack* HWY_RESTRICT l, ComplexPack* HWY_RESTRICT x) {
#pragma GCC unroll 8
  for (int i = n - 1; i > 0; --i)
#pragma GCC unroll 8
    for (int k = 0; k < i; ++k) x[k] = subtract_product(x[k], l[packed(i, k)], x[i]);
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
