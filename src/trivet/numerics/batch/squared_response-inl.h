// SPDX-License-Identifier: BSD-3-Clause
// |y|² of a channel y = s^d (c0 + s c1)ᵀ q under a real load as partial fractions in x = ω², one design per lane:
// y(s) y(−s) = Σ_k C_k / (x − z_k) + constant + slope x, z = −λ², C = −2 λ r y(−λ) with the residues r of y. Roots come
// in pairs: λ and its conjugate, or two real ones. A pair is one pair of numbers, (re, im) or (first, second):
// PairPack.
#if defined(TRIVET_NUMERICS_SQUARED_RESPONSE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_SQUARED_RESPONSE_INL_H_
#undef TRIVET_NUMERICS_SQUARED_RESPONSE_INL_H_
#else
#define TRIVET_NUMERICS_SQUARED_RESPONSE_INL_H_
#endif

#include <cassert>

#include "trivet/numerics/roots/modes-inl.h"
#include "trivet/numerics/roots/root_table.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

/// Two numbers of a pair of roots: real and imaginary part at the root with im > 0, or the values at two real roots.
struct PairPack {
  Pack first, second;
};

/// Product of such values.
HWY_INLINE PairPack times(const LaneMask& real, const PairPack& a, const PairPack& b) {
  const Pack low = hn::Mul(a.first, b.first), high = hn::Mul(a.second, b.second);
  return {hn::IfThenElse(real, low, hn::Sub(low, high)),
          hn::IfThenElse(real, high, hn::MulAdd(a.first, b.second, hn::Mul(a.second, b.first)))};
}
HWY_INLINE PairPack inverse(const LaneMask& real, const PairPack& a) {
  const Pack modulus = hn::MulAdd(a.first, a.first, hn::Mul(a.second, a.second));
  if (hn::AllFalse(Lanes(), real)) {
    const Pack scale = reciprocal(modulus);
    return {hn::Mul(a.first, scale), hn::Neg(hn::Mul(a.second, scale))};
  }
  const Pack low = reciprocal(hn::IfThenElse(real, a.first, modulus)),
             high = reciprocal(hn::IfThenElse(real, a.second, all(1.0)));
  return {hn::IfThenElse(real, low, hn::Mul(a.first, low)),
          hn::IfThenElse(real, high, hn::Neg(hn::Mul(a.second, low)))};
}
HWY_INLINE PairPack operator*(const Pack& a, const PairPack& b) { return {hn::Mul(a, b.first), hn::Mul(a, b.second)}; }
/// |first| + |second|
HWY_INLINE Pack sum_of_parts(const PairPack& a) { return hn::Add(hn::Abs(a.first), hn::Abs(a.second)); }
/// Modulus of the larger value, at most 9 % too large.
HWY_INLINE Pack modulus_of(const LaneMask& real, const PairPack& a) {
  const Pack first = hn::Abs(a.first), second = hn::Abs(a.second), larger = hn::Max(first, second);
  return hn::IfThenElse(real, larger, hn::MulAdd(all(0.41422), hn::Min(first, second), larger));
}
/// Half the sum over the pair.
HWY_INLINE Pack half_sum(const LaneMask& real, const PairPack& a) {
  return hn::IfThenElse(real, hn::Mul(all(0.5), hn::Add(a.first, a.second)), a.first);
}

/// Converts values at the two roots to numbers a, b such that half the sum of C · w over them is a w.first + b
/// w.second, w = w.first + w.second j (square_poles-inl.h); and back.
HWY_INLINE PairPack for_half_sum(const LaneMask& real, const PairPack& C) {
  const PairPack half = all(0.5) * C;
  return {hn::IfThenElse(real, hn::Add(half.first, half.second), C.first),
          hn::IfThenElse(real, hn::Sub(half.first, half.second), hn::Neg(C.second))};
}
HWY_INLINE PairPack at_poles(const LaneMask& real, const PairPack& a) {
  return {hn::IfThenElse(real, hn::Add(a.first, a.second), a.first),
          hn::IfThenElse(real, hn::Sub(a.first, a.second), hn::Neg(a.second))};
}

/// Poles of the response of eight designs.
struct PolePairs {
  int count = 0;
  PairPack lambda[most_pairs];
  LaneMask real[most_pairs];  ///< two real roots
};

/// Half of |y|² of several designs: Σ_k first · first + second · second of C_k and 1/(x − z_k) as numbers a + b j
/// (square_poles-inl.h), plus constant + slope x, and if it grows faster, plus growth · (x², x³, x⁴).
template <int most>
struct SquaredResponse {
  PairPack C[most];
  Pack parts[most];  ///< sums of the moduli of the terms of C_k, which may cancel
  Pack constant, slope;
  Pack constant_parts, slope_parts;  ///< sums of the moduli of their terms
  bool grows = false;                ///< faster than x: only for x ≥ 0 in a finite band
  Pack growth[3], growth_parts[3];
};

/// Σ g x^m, m = 2 … 4.
HWY_INLINE Pack growth_at(const Pack* g, const Pack& x) {
  return hn::Mul(hn::Mul(x, x), hn::MulAdd(x, hn::MulAdd(x, g[2], g[1]), g[0]));
}
/// Its derivative.
HWY_INLINE Pack growth_slope_at(const Pack* g, const Pack& x) {
  return hn::Mul(x,
                 hn::MulAdd(x, hn::MulAdd(x, hn::Mul(all(4.0), g[2]), hn::Mul(all(3.0), g[1])), hn::Add(g[0], g[0])));
}
/// Half of its second derivative.
HWY_INLINE Pack growth_bend_at(const Pack* g, const Pack& x) {
  return hn::MulAdd(x, hn::MulAdd(x, hn::Mul(all(6.0), g[2]), hn::Mul(all(3.0), g[1])), g[0]);
}
/// A sixth of its third derivative.
HWY_INLINE Pack growth_third_at(const Pack* g, const Pack& x) { return hn::MulAdd(x, hn::Mul(all(4.0), g[2]), g[1]); }

/// Poles in x = ω².
HWY_INLINE PairPack pole_in_square(const LaneMask& real, const PairPack& lambda) {
  const PairPack square = times(real, lambda, lambda);
  return {hn::Neg(square.first), hn::Neg(square.second)};
}

/// Factors in y(−λ_k) = Σ_l (β_l (s − p_l) + α_l) / D_l(s), s = −λ_k, that depend on the poles alone.
struct PoleProducts {
  PairPack linear[most_pairs][most_pairs];   ///< (s − p_l) / D_l
  PairPack inverse[most_pairs][most_pairs];  ///< 1 / D_l
};

/// D_l(−λ_k) = (λ_k + λ_l)(λ_k + λ̄_l), formed without differences in which light damping would be lost.
HWY_INLINE void form_products(const PolePairs& poles, PoleProducts& products) {
  for (int k = 0; k < poles.count; ++k)
    for (int l = 0; l < poles.count; ++l) {
      const LaneMask real_k = poles.real[k], real_l = poles.real[l];
      const PairPack a = poles.lambda[k], b = poles.lambda[l];
      const Pack zero = hn::Zero(Lanes());
      // Root k plus the two roots of l. Complex k: (re, im) of each sum; real k: the sums with b's (real) parts, per
      // root of k.
      const Pack other = hn::IfThenElse(real_l, b.second, b.first);
      const Pack im_l = hn::IfThenElse(real_l, zero, b.second);
      const ComplexPack plus = {hn::Add(a.first, b.first), hn::Add(a.second, im_l)},
                        minus = {hn::Add(a.first, other), hn::Sub(a.second, im_l)};
      const ComplexPack d = plus * minus;
      const Pack square = hn::Mul(im_l, im_l);
      const Pack d_first = hn::MulAdd(plus.re, minus.re, square);
      const Pack d_second = hn::MulAdd(hn::Add(a.second, b.first), hn::Add(a.second, other), square);
      const PairPack D = {hn::IfThenElse(real_k, d_first, d.re), hn::IfThenElse(real_k, d_second, d.im)};
      products.inverse[k][l] = inverse(real_k, D);
      // p_l: real part, or the second real root
      const PairPack s = {hn::Neg(minus.re), hn::Neg(hn::IfThenElse(real_k, hn::Add(a.second, other), a.second))};
      products.linear[k][l] = times(real_k, s, products.inverse[k][l]);
    }
}

/// |y|² from the residues r of y before its derivatives. `proper`: that y falls like 1/s², so that Σ C is set to zero
/// instead of its round-off.
template <int most>
HWY_INLINE void form_squared_response(const PolePairs& poles, const PoleProducts& products, const PairPack* r,
                                      int derivative, bool proper, SquaredResponse<most>& f) {
  const int n = poles.count;
  assert(n >= 0 && n <= most && derivative >= 0 && derivative <= 2 && "up to the acceleration");
  Pack beta[most_pairs], alpha[most_pairs];
  for (int l = 0; l < n; ++l) {
    const PairPack a = poles.lambda[l];
    beta[l] = hn::IfThenElse(poles.real[l], hn::Add(r[l].first, r[l].second), hn::Add(r[l].first, r[l].first));
    alpha[l] =
        hn::Mul(r[l].second, hn::IfThenElse(poles.real[l], hn::Sub(a.second, a.first), hn::Mul(all(-2.0), a.second)));
  }
  for (int k = 0; k < n; ++k) {
    PairPack y = {hn::Zero(Lanes()), hn::Zero(Lanes())};
    // y(−λ_k) = Σ_l (β_l (s − p_l) + α_l)/D_l at s = −λ_k, over pairs l of roots
    Pack moduli = hn::Zero(Lanes());
    for (int l = 0; l < n; ++l) {
      const PairPack linear = products.linear[k][l], inverse = products.inverse[k][l];
      moduli = hn::MulAdd(hn::Abs(alpha[l]), modulus_of(poles.real[k], inverse),
                          hn::MulAdd(hn::Abs(beta[l]), modulus_of(poles.real[k], linear), moduli));
      y.first = hn::MulAdd(alpha[l], inverse.first, hn::MulAdd(beta[l], linear.first, y.first));
      y.second = hn::MulAdd(alpha[l], inverse.second, hn::MulAdd(beta[l], linear.second, y.second));
    }
    f.C[k] = times(poles.real[k], all(-2.0) * poles.lambda[k], times(poles.real[k], r[k], y));
    f.parts[k] = hn::Mul(hn::Mul(all(2.0), modulus_of(poles.real[k], poles.lambda[k])),
                         hn::Mul(modulus_of(poles.real[k], r[k]), moduli));
  }
  f.constant = f.slope = f.constant_parts = f.slope_parts = hn::Zero(Lanes());
  for (int d = 0; d < derivative; ++d) {  // x/(x − z) = 1 + z/(x − z)
    f.slope = f.constant;
    f.slope_parts = f.constant_parts;
    f.constant = f.constant_parts = hn::Zero(Lanes());
    for (int k = 0; k < n; ++k) {
      if (d > 0 || !proper) {
        f.constant = hn::Add(f.constant, half_sum(poles.real[k], f.C[k]));
        f.constant_parts = hn::Add(f.constant_parts, f.parts[k]);
      }
      const PairPack z = pole_in_square(poles.real[k], poles.lambda[k]);
      f.C[k] = times(poles.real[k], z, f.C[k]);
      f.parts[k] = hn::Mul(modulus_of(poles.real[k], z), f.parts[k]);
    }
  }
  for (int k = 0; k < n; ++k) f.C[k] = for_half_sum(poles.real[k], f.C[k]);
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
