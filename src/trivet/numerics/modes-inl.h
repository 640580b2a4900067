// SPDX-License-Identifier: BSD-3-Clause
// K φ = λ A φ with one design per lane: Cholesky of A with a verdict on definiteness, then Jacobi rotations of L⁻¹ K L⁻ᵀ in rounds of
// pairs that do not touch each other, so that their angles are computed together. Rotations act on C = D Y D and Φ = X D with a diagonal
// D: two multiply-adds for a pair of numbers, D follows (fast rotations, [GolubVanLoan2013] 5.1.13 and 8.5).
#if defined(TRIVET_NUMERICS_MODES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_MODES_INL_H_
#undef TRIVET_NUMERICS_MODES_INL_H_
#else
#define TRIVET_NUMERICS_MODES_INL_H_
#endif

#include "trivet/numerics/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

/// 1/√x for x > 0, within two units in the last place.
HWY_INLINE Pack inverse_root(const Pack& x) {
#if HWY_TARGET <= HWY_AVX3
  const Pack half = hn::Mul(x, all(0.5));
  Pack y{_mm512_rsqrt14_pd(x.raw)};
  for (int step = 0; step < 2; ++step) y = hn::MulAdd(y, hn::NegMulAdd(hn::Mul(half, y), y, all(0.5)), y);
  return y;
#else
  return hn::Div(all(1.0), hn::Sqrt(x));
#endif
}

/// 1/x of moderate x, within two units in the last place.
HWY_INLINE Pack reciprocal(const Pack& x) {
#if HWY_TARGET <= HWY_AVX3
  Pack y{_mm512_rcp14_pd(x.raw)};
  for (int step = 0; step < 2; ++step) y = hn::MulAdd(y, hn::NegMulAdd(x, y, all(1.0)), y);
  return y;
#else
  return hn::Div(all(1.0), x);
#endif
}

/// How many coordinates: known to the compiler, which then unrolls all loops, or not, at most 12.
template <int N>
struct Fixed {
  static constexpr int most = N;
  constexpr operator int() const { return N; }  // NOLINT: it is that number
};
struct AtMostTwelve {
  static constexpr int most = 12;
  int value;
  constexpr operator int() const { return value; }  // NOLINT
};

/// Where the pair (i, j), j < i, stands among the pairs.
constexpr int pair(int i, int j) { return i * (i - 1) / 2 + j; }
constexpr int pair_of(int i, int j) { return i > j ? pair(i, j) : pair(j, i); }

/// C = D Y D and Φ = X D on the way to a diagonal C; at its end λ and Φ, one design per lane.
template <typename Size>
struct PackOfModes {
  Pack lambda[Size::most];                              ///< diagonal of C
  Pack y[Size::most * (Size::most - 1) / 2 + 1];        ///< Y below the diagonal
  Pack weight[Size::most];                              ///< D²
  Pack x[Size::most * Size::most];                      ///< X by columns of n
  Pack negligible;                                      ///< what of a product of two λ is round-off
};

/// x_p ← x_p − α x_q, x_q ← x_q + β x_p
HWY_INLINE void rotate(const Pack& alpha, const Pack& beta, Pack& x_p, Pack& x_q) {
  const Pack old = x_p;
  x_p = hn::NegMulAdd(alpha, x_q, x_p);
  x_q = hn::MulAdd(beta, old, x_q);
}

struct Angle {
  Pack alpha, beta;
};

/// The rotation that annihilates y(p, q), applied to the diagonals. Where `check`, `unsettled` becomes positive in a lane whose
/// rotation matters for the others: neither is c(p, q)² below round-off of λ_p λ_q, nor are tangent and c(p, q)² so small that their products are.
template <bool check, typename Size>
HWY_INLINE Angle angle(PackOfModes<Size>& m, int p, int q, Pack& unsettled) {
  Pack& z = m.y[pair_of(p, q)];
  const Pack difference = hn::Sub(m.lambda[q], m.lambda[p]);
  const Pack z_p = hn::Mul(m.weight[p], z), z_q = hn::Mul(m.weight[q], z);
  const Pack square = hn::Mul(z_p, z_q);
  const Pack distance = hn::Add(hn::Abs(difference), all(1e-140));  // no rotation where both vanish
  const Pack inverse = inverse_root(hn::MulAdd(distance, distance, hn::Mul(all(4.0), square)));  // cos 2θ = distance · inverse
  const Pack twice_cosine = hn::MulAdd(distance, inverse, all(1.0));                             // 2 cos²θ
  const Pack step = hn::CopySign(hn::Mul(hn::Add(inverse, inverse), reciprocal(twice_cosine)), difference);
  const Pack alpha = hn::Mul(step, z_q), beta = hn::Mul(step, z_p);
  const Pack cosine = hn::Mul(all(0.5), twice_cosine);
  m.lambda[p] = hn::NegMulAdd(alpha, z_p, m.lambda[p]);
  m.lambda[q] = hn::MulAdd(alpha, z_p, m.lambda[q]);
  m.weight[p] = hn::Mul(m.weight[p], cosine);
  m.weight[q] = hn::Mul(m.weight[q], cosine);
  z = hn::Zero(Lanes());
  if constexpr (check) {
    constexpr double small = 1e-15, round_off = 2e-31;
    const Pack product = hn::Add(hn::Abs(hn::Mul(m.lambda[p], m.lambda[q])), m.negligible);
    const Pack larger = hn::Max(square, hn::Mul(hn::Mul(alpha, beta), product));
    unsettled = hn::Max(unsettled, hn::Min(hn::NegMulAdd(all(small), product, larger), hn::NegMulAdd(all(round_off), product, square)));
  }
  return {alpha, beta};
}

template <bool vectors, typename Size>
HWY_INLINE void rotate(Size n, PackOfModes<Size>& m, const Angle& by, int p, int q) {
TRIVET_UNROLL
  for (int k = 0; k < n; ++k)
    if (k != p && k != q) rotate(by.alpha, by.beta, m.y[pair_of(k, p)], m.y[pair_of(k, q)]);
  if constexpr (vectors) {
TRIVET_UNROLL
    for (int k = 0; k < n; ++k) rotate(by.alpha, by.beta, m.x[p * n + k], m.x[q * n + k]);
  }
}

/// Each pair once, in rounds of pairs that share no index. A lane that is positive in the answer needs another turn.
template <bool vectors, bool check, typename Size>
HWY_INLINE Pack turn(Size n, PackOfModes<Size>& m) {
  const int rounds = n + n % 2 - 1, pairs = (rounds + 1) / 2;
  Pack unsettled = all(-1.0);
TRIVET_UNROLL
  for (int round = 0; round < rounds; ++round) {
    const auto first = [&](int k) { return k == 0 ? rounds : (round + k) % rounds; };
    const auto second = [&](int k) { return (round + rounds - k) % rounds; };
    Angle by[(Size::most + 1) / 2] = {};
TRIVET_UNROLL
    for (int k = 0; k < pairs; ++k)
      if (first(k) < n) by[k] = angle<check>(m, first(k), second(k), unsettled);
TRIVET_UNROLL
    for (int k = 0; k < pairs; ++k)
      if (first(k) < n) rotate<vectors>(n, m, by[k], first(k), second(k));
  }
  return unsettled;
}

/// A = L Lᵀ: L below the diagonal, the inverse of L with it. In lanes that are false in the answer A is not positive definite beyond
/// round-off: scaled to a unit diagonal, Σ 1/eigenvalue, which is not below 1/smallest, reaches 1/(8 n ε).
template <typename Size>
HWY_INLINE LaneMask cholesky(Size n, const Pack* a, Pack* l, Pack* inverse) {
  constexpr double epsilon = 2.220446049250313e-16;
  LaneMask definite = hn::Eq(all(0.0), all(0.0));
TRIVET_UNROLL
  for (int j = 0; j < n; ++j) {
    Pack square = a[packed(j, j)];
TRIVET_UNROLL
    for (int h = 0; h < j; ++h) square = hn::NegMulAdd(l[packed(j, h)], l[packed(j, h)], square);
    const LaneMask regular = hn::Gt(square, hn::Mul(all(epsilon), hn::Abs(a[packed(j, j)])));
    definite = hn::And(definite, regular);
    inverse[packed(j, j)] = inverse_root(hn::IfThenElse(regular, square, all(1.0)));
TRIVET_UNROLL
    for (int i = j + 1; i < n; ++i) {
      Pack x = a[packed(i, j)];
TRIVET_UNROLL
      for (int h = 0; h < j; ++h) x = hn::NegMulAdd(l[packed(i, h)], l[packed(j, h)], x);
      l[packed(i, j)] = hn::Mul(x, inverse[packed(j, j)]);
    }
  }
  Pack sum = all(0.0);
TRIVET_UNROLL
  for (int j = 0; j < n; ++j) {
    Pack column = hn::Mul(inverse[packed(j, j)], inverse[packed(j, j)]);
TRIVET_UNROLL
    for (int i = j + 1; i < n; ++i) {
      Pack x = hn::Mul(l[packed(i, j)], inverse[packed(j, j)]);
TRIVET_UNROLL
      for (int h = j + 1; h < i; ++h) x = hn::MulAdd(l[packed(i, h)], inverse[packed(h, j)], x);
      inverse[packed(i, j)] = hn::Neg(hn::Mul(x, inverse[packed(i, i)]));
      column = hn::MulAdd(inverse[packed(i, j)], inverse[packed(i, j)], column);
    }
    sum = hn::MulAdd(a[packed(j, j)], column, sum);
  }
  return hn::And(definite, hn::Lt(sum, all(1 / (8 * n * epsilon))));
}

/// L⁻¹ K, n × n by rows, l and the inverse of L as `cholesky` leaves them.
template <typename Size>
HWY_INLINE void divided_by_factor(Size n, const Pack* l, const Pack* inverse, const Pack* k, Pack* w) {
TRIVET_UNROLL
  for (int j = 0; j < n; ++j) {
TRIVET_UNROLL
    for (int i = 0; i < n; ++i) {
      Pack x = k[i > j ? packed(i, j) : packed(j, i)];
TRIVET_UNROLL
      for (int h = 0; h < i; ++h) x = hn::NegMulAdd(l[packed(i, h)], w[h * n + j], x);
      w[i * n + j] = hn::Mul(x, inverse[packed(i, i)]);
    }
  }
}

/// C = L⁻¹ K L⁻ᵀ and X = L⁻ᵀ. A lane where A is not positive definite or a number not finite is false in the answer and has C = 0.
template <bool vectors, typename Size>
HWY_INLINE LaneMask reduced(Size n, const Pack* a, const Pack* k, PackOfModes<Size>& m) {
  constexpr int triangle = Size::most * (Size::most + 1) / 2;
  Pack l[triangle], inverse[triangle], w[Size::most * Size::most], largest = all(0.0);
  LaneMask definite = cholesky(n, a, l, inverse);
  divided_by_factor(n, l, inverse, k, w);
TRIVET_UNROLL
  for (int i = 0; i < n; ++i) {
    Pack row[Size::most];
TRIVET_UNROLL
    for (int j = 0; j <= i; ++j) {
      Pack x = w[i * n + j];
TRIVET_UNROLL
      for (int h = 0; h < j; ++h) x = hn::NegMulAdd(row[h], l[packed(j, h)], x);
      row[j] = hn::Mul(x, inverse[packed(j, j)]);
      largest = hn::Add(largest, hn::Abs(row[j]));
      (j < i ? m.y[pair_of(i, j)] : m.lambda[i]) = row[j];
    }
    m.weight[i] = all(1.0);
  }
  definite = hn::And(definite, hn::Lt(largest, all(1e150)));
  m.negligible = hn::Mul(all(1e-34), hn::Mul(largest, largest));
TRIVET_UNROLL
  for (int i = 0; i < n; ++i) {
    m.lambda[i] = hn::IfThenElseZero(definite, m.lambda[i]);
TRIVET_UNROLL
    for (int j = 0; j < i; ++j) m.y[pair(i, j)] = hn::IfThenElseZero(definite, m.y[pair(i, j)]);
    if constexpr (vectors) {
TRIVET_UNROLL
      for (int j = 0; j < n; ++j) m.x[i * n + j] = j <= i ? inverse[packed(i, j)] : all(0.0);
    }
  }
  return definite;
}

/// Modes of a pack of designs from the packed lower triangles of A and K: λ in no order, shapes in the columns of x with φᵀAφ = 1. In lanes that are
/// false in the answer (A not positive definite beyond round-off, numbers not finite) λ is 0 and the shapes mean nothing.
template <bool vectors, typename Size>
HWY_INLINE LaneMask modes_of_pack(Size n, const Pack* a, const Pack* k, PackOfModes<Size>& m) {
  constexpr int unchecked_turns = 2, most_turns = 14;
  const LaneMask definite = reduced<vectors>(n, a, k, m);
  for (int i = 0; i < unchecked_turns; ++i) turn<vectors, false>(n, m);
  for (int i = unchecked_turns; i < most_turns; ++i)
    if (hn::AllTrue(Lanes(), hn::Le(turn<vectors, true>(n, m), all(0.0)))) break;
  if constexpr (vectors) {
TRIVET_UNROLL
    for (int i = 0; i < n; ++i) {
      const Pack d = hn::Mul(m.weight[i], inverse_root(m.weight[i]));
TRIVET_UNROLL
      for (int j = 0; j < n; ++j) m.x[i * n + j] = hn::Mul(d, m.x[i * n + j]);
    }
  }
  return definite;
}

/// λ ascending, the shapes with them.
template <bool vectors, typename Size>
HWY_INLINE void sort(Size n, PackOfModes<Size>& m) {
TRIVET_UNROLL
  for (int last = n - 1; last > 0; --last) {
TRIVET_UNROLL
    for (int i = 0; i < last; ++i) {
      const Pack one = m.lambda[i], two = m.lambda[i + 1];
      m.lambda[i] = hn::Min(one, two);
      m.lambda[i + 1] = hn::Max(one, two);
      if constexpr (vectors) {
        const LaneMask keep = hn::Le(one, two);
TRIVET_UNROLL
        for (int j = 0; j < n; ++j) {
          const Pack x = m.x[i * n + j], y = m.x[(i + 1) * n + j];
          m.x[i * n + j] = hn::IfThenElse(keep, x, y);
          m.x[(i + 1) * n + j] = hn::IfThenElse(keep, y, x);
        }
      }
    }
  }
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
