// SPDX-License-Identifier: BSD-3-Clause
// Rayleigh quotient iteration for symmetric quadratic problems, one design per lane: M(λ) u = M'(λ) v, λ from
// uᵀM(λ)u = 0; cubic convergence. A root near iΩ_k is stored as i·centre + offset, so that Re λ has all its digits with
// any light damping: M is formed from differences of frequencies, never from differences of squares.
#if defined(TRIVET_NUMERICS_RAYLEIGH_ITERATION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_RAYLEIGH_ITERATION_INL_H_
#undef TRIVET_NUMERICS_RAYLEIGH_ITERATION_INL_H_
#else
#define TRIVET_NUMERICS_RAYLEIGH_ITERATION_INL_H_
#endif

#include "trivet/numerics/roots/modes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

HWY_INLINE ComplexPack zero() { return {all(0.0), all(0.0)}; }
HWY_INLINE ComplexPack conjugate(const ComplexPack& z) { return {z.re, hn::Neg(z.im)}; }
HWY_INLINE ComplexPack select(LaneMask mask, const ComplexPack& yes, const ComplexPack& no) {
  return {hn::IfThenElse(mask, yes.re, no.re), hn::IfThenElse(mask, yes.im, no.im)};
}
/// target + a b with real a
HWY_INLINE ComplexPack add_product(const ComplexPack& target, const Pack& a, const ComplexPack& b) {
  return {hn::MulAdd(a, b.re, target.re), hn::MulAdd(a, b.im, target.im)};
}
HWY_INLINE ComplexPack quick_inverse(const ComplexPack& z) {
  const Pack scale = reciprocal(squared_modulus(z));
  return {hn::Mul(z.re, scale), hn::Neg(hn::Mul(z.im, scale))};
}
HWY_INLINE ComplexPack divided(const ComplexPack& a, const ComplexPack& b) { return a * quick_inverse(b); }

/// √z with Re ≥ 0, within a few units in the last place; √0 = 0.
HWY_INLINE ComplexPack root(const ComplexPack& z) {
  const Pack square = hn::Add(squared_modulus(z), all(1e-280)), modulus = hn::Mul(square, inverse_root(square));
  const Pack half = hn::Mul(all(0.5), hn::Add(modulus, hn::Abs(z.re))), by_larger = inverse_root(half);
  const Pack larger = hn::Mul(half, by_larger), smaller = hn::Mul(hn::Mul(all(0.5), hn::Abs(z.im)), by_larger);
  const LaneMask right = hn::Ge(z.re, all(0.0));
  return {hn::IfThenElse(right, larger, smaller), hn::CopySign(hn::IfThenElse(right, smaller, larger), z.im)};
}

/// M(λ) = λ² + λB + Ω², with loss factors + iD, for one root, λ = i centre + offset; the root's own mode is last.
template <typename Size, bool lossy = false>
struct Pencil {
  Pack below[Size::most];  ///< centre − Ω_j
  Pack above[Size::most];  ///< centre + Ω_j
  Pack b[Size::most * (Size::most + 1) / 2];
  Pack d[lossy ? Size::most * (Size::most + 1) / 2 : 1];
  Pack centre;
  int own = 0;  ///< the root's own mode
};

template <typename Size>
struct Root {
  ComplexPack offset;
  ComplexPack v[Size::most];  ///< length 1
  ComplexPack bv[Size::most];
  ComplexPack slope;  ///< vᵀ M'(λ) v
  Pack turned;        ///< sin² of the angle between v and the previous v
};

/// λ with its frequency rounded to double.
template <typename Size, bool lossy>
HWY_INLINE ComplexPack value(const Pencil<Size, lossy>& m, const ComplexPack& offset) {
  return {offset.re, hn::Add(m.centre, offset.im)};
}

/// λ² + Ω_j² + λB_jj (+ iD_jj) without cancellation.
template <typename Size, bool lossy>
HWY_INLINE ComplexPack diagonal(const Pencil<Size, lossy>& m, const ComplexPack& offset, int j) {
  const Pack x = offset.re, y = hn::Add(m.centre, offset.im), b = m.b[packed(j, j)];
  const Pack difference = hn::Add(m.below[j], offset.im), sum = hn::Add(m.above[j], offset.im);
  const Pack re = hn::NegMulAdd(difference, sum, hn::Mul(x, hn::Add(x, b)));
  if constexpr (lossy) return {re, hn::MulAdd(y, hn::Add(hn::Add(x, x), b), m.d[packed(j, j)])};
  else return {re, hn::Mul(y, hn::Add(hn::Add(x, x), b))};
}

/// λB_ij (+ iD_ij), i ≠ j.
template <typename Size, bool lossy>
HWY_INLINE ComplexPack coupling(const Pencil<Size, lossy>& m, const ComplexPack& lambda, int i, int j) {
  const int entry = packed_of(i, j);
  if constexpr (lossy) return {hn::Mul(m.b[entry], lambda.re), hn::MulAdd(m.b[entry], lambda.im, m.d[entry])};
  else return m.b[entry] * lambda;
}

/// S v with a packed symmetric S.
template <typename Size>
HWY_INLINE void symmetric_times(Size n, const Pack* entries, const ComplexPack* v, ComplexPack* result) {
  each(n, [&](int i) TRIVET_LANES {
    result[i] = entries[packed(i, 0)] * v[0];
    each(Fixed<1>(), n,
         [&](int j) TRIVET_LANES { result[i] = add_product(result[i], entries[packed_of(i, j)], v[j]); });
  });
}

/// Scales v to length 1; returns the factor.
template <typename Size>
HWY_INLINE Pack normalise(Size n, ComplexPack* v) {
  Pack length = all(0.0);
  each(n, [&](int i) TRIVET_LANES { length = hn::MulAdd(v[i].re, v[i].re, hn::MulAdd(v[i].im, v[i].im, length)); });
  const Pack scale = inverse_root(length);
  each(n, [&](int i) TRIVET_LANES { v[i] = scale * v[i]; });
  return scale;
}

/// λ minus the nearer root of a quadratic with this value, slope and half its second derivative at λ; third order.
HWY_INLINE ComplexPack to_root(const ComplexPack& value, const ComplexPack& slope, const ComplexPack& square) {
  return divided(value, subtract_product(slope, square, divided(value, slope)));
}

/// Starts from the root of the last diagonal entry: v is the last unit vector, corrected for each other mode as if it
/// were the only one.
template <typename Size, bool lossy>
HWY_INLINE void start(Size n, const Pencil<Size, lossy>& m, Root<Size>& at) {
  const ComplexPack lambda = value(m, at.offset);
  const int own = n - 1;
  ComplexPack entry[Size::most], square = zero(), middle = zero(), p = zero();
  each(n, [&](int j) TRIVET_LANES {
    entry[j] = diagonal(m, at.offset, j);
    at.v[j] = {all(1.0), all(0.0)};
    if (j == own) return;
    const ComplexPack one = coupling(m, lambda, own, j), twice = one + one;
    const ComplexPack radical = root(add_product(twice * twice, entry[j], entry[j]));
    const Pack projection = hn::MulAdd(entry[j].re, radical.re, hn::Mul(entry[j].im, radical.im));
    // Of two equal modes one takes the sum and the other the difference.
    const Pack same =
        hn::IfThenElse(hn::Eq(projection, all(0.0)), all(j >= m.own ? 1.0 : -1.0), hn::CopySign(all(1.0), projection));
    ComplexPack denominator = add_product(entry[j], same, radical);  // the larger of entry ± radical
    denominator.re = hn::IfThenElse(hn::Gt(one_norm(denominator), all(0.0)), denominator.re, all(1.0));
    const ComplexPack turn = divided(twice, denominator);
    at.v[j] = {hn::Neg(turn.re), hn::Neg(turn.im)};
  });
  normalise(n, at.v);
  symmetric_times(n, m.b, at.v, at.bv);
  each(n, [&](int j) TRIVET_LANES {
    const ComplexPack own_square = at.v[j] * at.v[j];
    square = square + own_square;
    middle = add_product(middle, at.v[j], at.bv[j]);
    p = add_product(p, own_square, entry[j] - m.b[packed(j, j)] * lambda);
  });
  p = add_product(p, lambda, middle);
  if constexpr (lossy) {  // entry contains the diagonal of iD
    ComplexPack dv[Size::most], beside = zero();
    symmetric_times(n, m.d, at.v, dv);
    each(n, [&](int j) TRIVET_LANES { beside = add_product(beside, at.v[j], dv[j] - m.d[packed(j, j)] * at.v[j]); });
    p = p + ComplexPack{hn::Neg(beside.im), beside.re};
  }
  at.offset = at.offset - to_root(p, add_product(middle, lambda + lambda, square), square);
}

/// Factors M = L D Lᵀ, and the solution u of M(λ) u = r. Pivots are at least 1e-60 of (centre + Ω)², because λ may be a
/// root to the last digit.
template <typename Size>
struct Factors {
  ComplexPack lambda, l[Size::most * Size::most], by_pivot[Size::most], u[Size::most];

  template <typename Row, bool lossy>
  HWY_INLINE void eliminate(Size n, const Pencil<Size, lossy>& m, const ComplexPack& offset, Row i) {
    ComplexPack row[Size::most], pivot = diagonal(m, offset, i);
    each(i, [&](auto j) TRIVET_LANES {
      row[j] = coupling(m, lambda, i, j);
      each(j, [&](int k) TRIVET_LANES { row[j] = subtract_product(row[j], row[k], l[j * n + k]); });
      l[i * n + j] = row[j] * by_pivot[j];
      pivot = subtract_product(pivot, row[j], l[i * n + j]);
      u[i] = subtract_product(u[i], l[i * n + j], u[j]);
    });
    const Pack least = hn::Mul(all(1e-60), hn::Mul(m.above[i], m.above[i]));
    const LaneMask regular = hn::Gt(one_norm(pivot), least);
    by_pivot[i] = quick_inverse({hn::IfThenElse(regular, pivot.re, least), hn::IfThenElseZero(regular, pivot.im)});
  }

  /// Completes u; returns uᵀ r.
  HWY_INLINE ComplexPack substitute(Size n) {
    ComplexPack product = zero();
    each(n, [&](int i) TRIVET_LANES {
      const ComplexPack scaled = u[i] * by_pivot[i];
      product = add_product(product, u[i], scaled);
      u[i] = scaled;
    });
    each(n, [&](auto back) TRIVET_LANES {
      const int i = n - 1 - back;
      each(back, [&](int other) TRIVET_LANES {
        u[i] = subtract_product(u[i], l[(n - 1 - other) * n + i], u[n - 1 - other]);
      });
    });
    return product;
  }
};

/// One step of the iteration for several roots at once, so that their latencies overlap.
template <typename Size, bool lossy, int roots>
HWY_INLINE void step(Size n, const Pencil<Size, lossy> (&m)[roots], Root<Size> (&at)[roots]) {
  Factors<Size> factors[roots];
  each(Fixed<roots>(), [&](int r) TRIVET_LANES {
    factors[r].lambda = value(m[r], at[r].offset);
    each(n, [&](int i) TRIVET_LANES {
      factors[r].u[i] = add_product(at[r].bv[i], factors[r].lambda + factors[r].lambda, at[r].v[i]);
    });
  });
  each(n, [&](auto i) TRIVET_LANES {
    each(Fixed<roots>(), [&](int r) TRIVET_LANES { factors[r].eliminate(n, m[r], at[r].offset, i); });
  });
  each(Fixed<roots>(), [&](int r) TRIVET_LANES {
    ComplexPack p = factors[r].substitute(n), *u = factors[r].u, square = zero(), middle = zero(), along = zero();
    const Pack scale = normalise(n, u);
    symmetric_times(n, m[r].b, u, at[r].bv);
    each(n, [&](int i) TRIVET_LANES {
      along = add_product(along, conjugate(at[r].v[i]), u[i]);
      square = add_product(square, u[i], u[i]);
      middle = add_product(middle, u[i], at[r].bv[i]);
      at[r].v[i] = u[i];
    });
    const ComplexPack slope = add_product(middle, factors[r].lambda + factors[r].lambda, square);
    const ComplexPack change = to_root(hn::Mul(scale, scale) * p, slope, square);
    at[r].offset = at[r].offset - change;
    at[r].slope = subtract_product(slope, change + change, square);
    at[r].turned = hn::Sub(all(1.0), squared_modulus(along));
  });
}

/// Iterates from the roots of the last diagonal entries until v converges in all lanes: sin² of its last turn is at
/// most `settled`, and the remaining error is the third power of that angle.
template <typename Size, bool lossy, int roots>
HWY_INLINE LaneMask converge(Size n, const Pencil<Size, lossy> (&m)[roots], Root<Size> (&at)[roots]) {
  constexpr int most_steps = 6;
  constexpr double settled = 1e-8;
  each(Fixed<roots>(), [&](int r) TRIVET_LANES { start(n, m[r], at[r]); });
  Pack turned = all(1.0);
  for (int i = 0; i < most_steps; ++i) {
    step(n, m, at);
    turned = all(0.0);
    each(Fixed<roots>(),
         [&](int r) TRIVET_LANES { turned = hn::IfThenElse(hn::Le(at[r].turned, all(settled)), turned, all(1.0)); });
    if (hn::AllTrue(Lanes(), hn::Eq(turned, all(0.0)))) break;
  }
  return hn::Eq(turned, all(0.0));
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
