// SPDX-License-Identifier: BSD-3-Clause
// Z = LDLᵀ of complex symmetric Z without pivoting, one frequency per lane, with unrolled loops for a fixed number of
// coordinates. Include after hwy/foreach_target.h only.
#if defined(TRIVET_NUMERICS_SYMMETRIC_SOLVE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_SYMMETRIC_SOLVE_INL_H_
#undef TRIVET_NUMERICS_SYMMETRIC_SOLVE_INL_H_
#else
#define TRIVET_NUMERICS_SYMMETRIC_SOLVE_INL_H_
#endif

#include "trivet/foundation/index.h"
#include "trivet/numerics/lanes/lanes-inl.h"
#include "trivet/numerics/sweep/sweep_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

HWY_INLINE Pack load_pack(const double* from) { return hn::LoadU(Lanes(), from); }
HWY_INLINE void store_pack(const Pack& pack, double* to) { hn::StoreU(pack, Lanes(), to); }
HWY_INLINE ComplexPack load_pack(const Planes& planes, long at) {
  return {load_pack(planes.re + at), load_pack(planes.im + at)};
}
HWY_INLINE void store_pack(const ComplexPack& z, const Planes& planes, long at) {
  store_pack(z.re, planes.re + at);
  store_pack(z.im, planes.im + at);
}

/// Σ (trace of |L||D||Lᵀ| by columns)² and Σ 1/|d|²: they determine whether a factorisation without pivoting is
/// trusted.
struct Growth {
  Pack squares, reciprocals;
};

/// c₀ + c₁ ω + c₂ ω² + c₃ ω⁴
HWY_INLINE Pack polynomial(const double* c, const Pack& omega, const Pack& square) {
  return hn::MulAdd(hn::MulAdd(all(c[3]), square, all(c[2])), square, hn::MulAdd(all(c[1]), omega, all(c[0])));
}

/// Lanes with a trusted factorisation; false also for NaN.
HWY_INLINE LaneMask trusted(const Growth& growth, const Pack& norm, int n) {
  const double negligible = negligible_pivot(n), most = sweep_kernels::growth_allowed;
  return hn::And(hn::Le(growth.squares, hn::Mul(all(most * most), norm)),
                 hn::Lt(hn::Mul(growth.reciprocals, norm), all(1 / (negligible * negligible))));
}

/// Solves `packs` packs of frequencies from `at` on together: while one waits for a quotient, the other is computed.
template <int n, int packs, bool aimed>
HWY_INLINE LaneMask solve_packs(const sweep_kernels::Coefficients& z, const sweep_kernels::Aim* aim,
                                const sweep_kernels::Batch& batch, long at) {
  const long width = lane_count();
  Pack omega[packs], square[packs], lr[n * n][packs], li[n * n][packs], ur[n * n][packs], ui[n * n][packs],
      er[n][packs], ei[n][packs];
  Growth growth[packs];
  TRIVET_UNROLL for (int p = 0; p < packs; ++p) {
    omega[p] = load_pack(batch.omega + at + p * width);
    square[p] = hn::Mul(omega[p], omega[p]);
    growth[p] = {hn::Zero(Lanes()), hn::Zero(Lanes())};
  }
  TRIVET_UNROLL for (int j = 0; j < n; ++j) {
    Pack column[packs], reciprocal[packs];
    TRIVET_UNROLL for (int i = j; i < n; ++i) {
      TRIVET_UNROLL for (int p = 0; p < packs; ++p) {
        Pack re = hn::NegMulAdd(square[p], all(z.A[i * n + j]), all(z.K[i * n + j]));
        Pack im = hn::MulAdd(omega[p], all(z.B[i * n + j]), all(z.K_loss[i * n + j]));
        TRIVET_UNROLL for (int k = 0; k < j; ++k) {
          const int a = i * n + k, b = j * n + k;
          re = hn::NegMulAdd(lr[a][p], ur[b][p], re);
          im = hn::NegMulAdd(lr[a][p], ui[b][p], im);
          re = hn::MulAdd(li[a][p], ui[b][p], re);
          im = hn::NegMulAdd(li[a][p], ur[b][p], im);
        }
        if (i == j) {
          const Pack modulus = hn::MulAdd(re, re, hn::Mul(im, im));
          reciprocal[p] = hn::Div(all(1.0), modulus);
          er[j][p] = hn::Mul(re, reciprocal[p]);
          ei[j][p] = hn::Mul(im, reciprocal[p]);
          column[p] = j == 0 ? polynomial(z.first, omega[p], square[p]) : modulus;
          growth[p].reciprocals = hn::Add(growth[p].reciprocals, reciprocal[p]);
        } else {
          ur[i * n + j][p] = re;
          ui[i * n + j][p] = im;
          if (j > 0) column[p] = hn::MulAdd(re, re, hn::MulAdd(im, im, column[p]));
          lr[i * n + j][p] = hn::MulAdd(re, er[j][p], hn::Mul(im, ei[j][p]));
          li[i * n + j][p] = hn::NegMulAdd(re, ei[j][p], hn::Mul(im, er[j][p]));
        }
      }
    }
    TRIVET_UNROLL for (int p = 0; p < packs; ++p) growth[p].squares =
        hn::MulAdd(hn::Mul(column[p], column[p]), reciprocal[p], growth[p].squares);
  }
  ComplexPack q[n][packs];
  TRIVET_UNROLL for (int i = 0; i < n; ++i) TRIVET_UNROLL for (int p = 0; p < packs; ++p) {
    if (aimed && i < n - 1) continue;
    q[i][p] = load_pack(batch.load, (aimed ? 0 : i) * batch.load.stride + at + p * width);
    TRIVET_UNROLL for (int k = 0; k < i && !aimed; ++k) q[i][p] =
        subtract_product(q[i][p], ComplexPack{lr[i * n + k][p], li[i * n + k][p]}, q[k][p]);
  }
  TRIVET_UNROLL for (int i = n - 1; i >= 0; --i) {
    const int to = aimed ? aim->order[i] : i;
    TRIVET_UNROLL for (int p = 0; p < packs; ++p) {
      ComplexPack& x = q[i][p];
      if (!aimed || i == n - 1) {
        x = ComplexPack{hn::MulAdd(x.re, er[i][p], hn::Mul(x.im, ei[i][p])),
                        hn::NegMulAdd(x.re, ei[i][p], hn::Mul(x.im, er[i][p]))};
      } else {
        const Pack &re = lr[(n - 1) * n + i][p], &im = li[(n - 1) * n + i][p];
        x = {hn::NegMulAdd(re, q[n - 1][p].re, hn::Mul(im, q[n - 1][p].im)),
             hn::NegMulSub(re, q[n - 1][p].im, hn::Mul(im, q[n - 1][p].re))};
      }
      TRIVET_UNROLL for (int k = aimed ? n - 2 : n - 1; k > i; --k) x =
          subtract_product(x, ComplexPack{lr[k * n + i][p], li[k * n + i][p]}, q[k][p]);
      if (!aimed || i < n - 1) store_pack(all(batch.scale[to]) * x, batch.q, to * batch.q.stride + at + p * width);
    }
  }
  LaneMask fine = hn::FirstN(Lanes(), to_size(width));
  TRIVET_UNROLL for (int p = 0; p < packs; ++p) {
    if (aimed) {
      const int to = aim->order[n - 1];
      TRIVET_UNROLL for (int i = n - 2; i >= 0; --i) q[n - 1][p] =
          subtract_product(q[n - 1][p], all(aim->ratio[i]), q[i][p]);
      store_pack(all(batch.scale[to]) * q[n - 1][p], batch.q, to * batch.q.stride + at + p * width);
    }
    const LaneMask good = trusted(growth[p], polynomial(z.norm, omega[p], square[p]), n);
    if (!hn::AllTrue(Lanes(), good)) store_pack(hn::IfThenZeroElse(good, all(1.0)), batch.error + at + p * width);
    fine = hn::And(fine, good);
  }
  return fine;
}

template <int n, bool aimed>
bool solve_all(const sweep_kernels::Coefficients& z, const sweep_kernels::Aim* aim, const sweep_kernels::Batch& batch) {
  constexpr int packs = aimed ? 2 : 1;
  LaneMask fine = hn::FirstN(Lanes(), 8);
  for (long at = 0; at < batch.count; at += long{packs} * lane_count())
    fine = hn::And(fine, solve_packs<n, packs, aimed>(z, aim, batch, at));
  return hn::AllTrue(Lanes(), fine);
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
