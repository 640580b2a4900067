// SPDX-License-Identifier: BSD-3-Clause
// K φ = λ A φ with one design per lane: Cholesky of A with a check that it is definite, then Jacobi rotations of L⁻¹ K
// L⁻ᵀ in rounds of disjoint pairs, so that their angles are computed together. Rotations act on Y and X of C = D Y D
// and Φ = X D with a diagonal D: two multiply-adds for a pair of numbers, D is updated separately (fast Givens
// rotations: W. Rath, Numerische Mathematik 40, 1982).
#if defined(TRIVET_NUMERICS_MODES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_MODES_INL_H_
#undef TRIVET_NUMERICS_MODES_INL_H_
#else
#define TRIVET_NUMERICS_MODES_INL_H_
#endif

#include "trivet/numerics/lanes/lanes-inl.h"

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

/// Rounds that pair each of n indices once with each other one, and pairs per round.
template <int N>
constexpr Fixed<N + N % 2 - 1> rounds_of(Fixed<N>) {
  return {};
}
constexpr int rounds_of(int n) { return n + n % 2 - 1; }
template <int N>
constexpr Fixed<(N + 1) / 2> pairs_of(Fixed<N>) {
  return {};
}
constexpr int pairs_of(int n) { return (n + 1) / 2; }

/// Position of the pair (i, j), j < i, among the pairs.
constexpr int pair(int i, int j) { return i * (i - 1) / 2 + j; }
constexpr int pair_of(int i, int j) { return i > j ? pair(i, j) : pair(j, i); }

/// C = D Y D and Φ = X D during the iteration to a diagonal C; at its end λ and Φ, one design per lane.
template <typename Size>
struct PackOfModes {
  Pack lambda[Size::most];                        ///< diagonal of C
  Pack y[Size::most * (Size::most - 1) / 2 + 1];  ///< Y below the diagonal
  Pack weight[Size::most];                        ///< D²
  Pack x[Size::most * Size::most];                ///< X by columns of n
  Pack negligible;                                ///< round-off of a product of two λ
  LaneMask settled;                               ///< no significant rotation is left
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

/// Rotation by θ that annihilates y(p, q), applied to the diagonals. With `check`, `unsettled` becomes positive in
/// lanes with a significant rotation: c(p, q)² exceeds the round-off of λ_p λ_q, and c(p, q)²/(λ_p λ_q) or tan²θ
/// exceeds 1e-15.
template <bool check, typename Size>
HWY_INLINE Angle angle(PackOfModes<Size>& m, int p, int q, Pack& unsettled) {
  Pack& z = m.y[pair_of(p, q)];
  const Pack difference = hn::Sub(m.lambda[q], m.lambda[p]);
  const Pack z_p = hn::Mul(m.weight[p], z), z_q = hn::Mul(m.weight[q], z);
  const Pack square = hn::Mul(z_p, z_q);
  const Pack distance = hn::Add(hn::Abs(difference), all(1e-140));  // no rotation if both vanish
  const Pack inverse =
      inverse_root(hn::MulAdd(distance, distance, hn::Mul(all(4.0), square)));  // cos 2θ = distance · inverse
  const Pack twice_cosine = hn::MulAdd(distance, inverse, all(1.0));            // 2 cos²θ
  Pack step = hn::CopySign(hn::Mul(hn::Add(inverse, inverse), reciprocal(twice_cosine)), difference),
       cosine = hn::Mul(all(0.5), twice_cosine), product;
  if constexpr (check) {
    constexpr double nothing =
        1e-40;  // smaller rotations are skipped: their numbers would shrink until they are subnormal and slow
    product = hn::Add(hn::Abs(hn::Mul(m.lambda[p], m.lambda[q])), m.negligible);
    const LaneMask matters = hn::Gt(square, hn::Mul(all(nothing), product));
    step = hn::IfThenElseZero(matters, step);
    cosine = hn::IfThenElse(matters, cosine, all(1.0));
  }
  const Pack alpha = hn::Mul(step, z_q), beta = hn::Mul(step, z_p);
  m.lambda[p] = hn::NegMulAdd(alpha, z_p, m.lambda[p]);
  m.lambda[q] = hn::MulAdd(alpha, z_p, m.lambda[q]);
  m.weight[p] = hn::Mul(m.weight[p], cosine);
  m.weight[q] = hn::Mul(m.weight[q], cosine);
  z = hn::Zero(Lanes());
  if constexpr (check) {
    constexpr double small = 1e-15, round_off = 2e-31;
    const Pack larger = hn::Max(square, hn::Mul(hn::Mul(alpha, beta), product));
    unsettled = hn::Max(
        unsettled, hn::Min(hn::NegMulAdd(all(small), product, larger), hn::NegMulAdd(all(round_off), product, square)));
  }
  return {alpha, beta};
}

/// One Jacobi sweep: each pair once, in rounds of disjoint pairs. Lanes with a positive result need another sweep.
template <bool vectors, bool check, typename Size>
HWY_INLINE Pack turn(Size n, PackOfModes<Size>& m) {
  const auto rounds = rounds_of(n);
  const auto pairs = pairs_of(n);
  Pack unsettled = all(-1.0);
  each(rounds, [&](int round) TRIVET_LANES {
    const auto first = [&](int k) { return k == 0 ? int(rounds) : (round + k) % rounds; };
    const auto second = [&](int k) { return (round + rounds - k) % rounds; };
    Angle by[(Size::most + 1) / 2];
    each(pairs, [&](int k) TRIVET_LANES {
      if (first(k) < n) by[k] = angle<check>(m, first(k), second(k), unsettled);
    });
    each(pairs, [&](int k) TRIVET_LANES {
      const int p = first(k), q = second(k);
      if (p >= n) return;
      each(n, [&](int i) TRIVET_LANES {
        if (i != p && i != q) rotate(by[k].alpha, by[k].beta, m.y[pair_of(i, p)], m.y[pair_of(i, q)]);
        if constexpr (vectors) rotate(by[k].alpha, by[k].beta, m.x[p * n + i], m.x[q * n + i]);
      });
    });
  });
  return unsettled;
}

/// A = L Lᵀ: L below the diagonal, and the inverse of L. Returns the lanes in which A is positive definite beyond
/// round-off: scaled to a unit diagonal, Σ 1/eigenvalue, which is at least 1/smallest, is below 1/(8 n ε).
template <typename Size>
HWY_INLINE LaneMask cholesky(Size n, const Pack* a, Pack* l, Pack* inverse) {
  constexpr double epsilon = 2.220446049250313e-16;
  LaneMask definite = hn::Eq(all(0.0), all(0.0));
  each(n, [&](auto j) TRIVET_LANES {
    Pack square = a[packed(j, j)];
    each(j, [&](int h) TRIVET_LANES { square = hn::NegMulAdd(l[packed(j, h)], l[packed(j, h)], square); });
    const LaneMask regular = hn::Gt(square, hn::Mul(all(epsilon), hn::Abs(a[packed(j, j)])));
    definite = hn::And(definite, regular);
    inverse[packed(j, j)] = inverse_root(hn::IfThenElse(regular, square, all(1.0)));
    each(after(j), n, [&](int i) TRIVET_LANES {
      Pack x = a[packed(i, j)];
      each(j, [&](int h) TRIVET_LANES { x = hn::NegMulAdd(l[packed(i, h)], l[packed(j, h)], x); });
      l[packed(i, j)] = hn::Mul(x, inverse[packed(j, j)]);
    });
  });
  Pack sum = all(0.0);
  each(n, [&](auto j) TRIVET_LANES {
    Pack column = hn::Mul(inverse[packed(j, j)], inverse[packed(j, j)]);
    each(after(j), n, [&](auto i) TRIVET_LANES {
      Pack x = hn::Mul(l[packed(i, j)], inverse[packed(j, j)]);
      each(after(j), i, [&](int h) TRIVET_LANES { x = hn::MulAdd(l[packed(i, h)], inverse[packed(h, j)], x); });
      inverse[packed(i, j)] = hn::Neg(hn::Mul(x, inverse[packed(i, i)]));
      column = hn::MulAdd(inverse[packed(i, j)], inverse[packed(i, j)], column);
    });
    sum = hn::MulAdd(a[packed(j, j)], column, sum);
  });
  return hn::And(definite, hn::Lt(sum, all(1 / (8 * n * epsilon))));
}

/// L⁻¹ K L⁻ᵀ: diagonal and pairs below it; l and the inverse of L are those of `cholesky`. Returns the sum of moduli.
template <typename Size>
HWY_INLINE Pack transformed(Size n, const Pack* l, const Pack* inverse, const Pack* k, Pack* diagonal, Pack* below) {
  Pack w[Size::most * Size::most], largest = all(0.0);
  each(n, [&](auto i) TRIVET_LANES {
    each(n, [&](int j) TRIVET_LANES {
      Pack x = k[packed_of(i, j)];
      each(i, [&](int h) TRIVET_LANES { x = hn::NegMulAdd(l[packed(i, h)], w[h * n + j], x); });
      w[i * n + j] = hn::Mul(x, inverse[packed(i, i)]);
    });
    Pack row[Size::most];
    each(after(i), [&](auto j) TRIVET_LANES {
      Pack x = w[i * n + j];
      each(j, [&](int h) TRIVET_LANES { x = hn::NegMulAdd(row[h], l[packed(j, h)], x); });
      row[j] = hn::Mul(x, inverse[packed(j, j)]);
      largest = hn::Add(largest, hn::Abs(row[j]));
      (j < i ? below[pair_of(i, j)] : diagonal[i]) = row[j];
    });
  });
  return largest;
}

/// C = L⁻¹ K L⁻ᵀ and X = L⁻ᵀ. Returns the lanes in which A is positive definite and all numbers are finite; the other
/// lanes have C = 0.
template <bool vectors, typename Size>
HWY_INLINE LaneMask reduced(Size n, const Pack* a, const Pack* k, PackOfModes<Size>& m) {
  constexpr int triangle = Size::most * (Size::most + 1) / 2;
  Pack l[triangle], inverse[triangle];
  LaneMask definite = cholesky(n, a, l, inverse);
  const Pack largest = transformed(n, l, inverse, k, m.lambda, m.y);
  definite = hn::And(definite, hn::Lt(largest, all(1e150)));
  m.negligible = hn::Mul(all(1e-34), hn::Mul(largest, largest));
  each(n, [&](auto i) TRIVET_LANES {
    m.weight[i] = all(1.0);
    m.lambda[i] = hn::IfThenElseZero(definite, m.lambda[i]);
    each(i, [&](int j) TRIVET_LANES { m.y[pair(i, j)] = hn::IfThenElseZero(definite, m.y[pair(i, j)]); });
    if constexpr (vectors)
      each(n, [&](int j) TRIVET_LANES { m.x[i * n + j] = j <= i ? inverse[packed_of(i, j)] : all(0.0); });
  });
  return definite;
}

/// Modes of a pack of designs from the packed lower triangles of A and K: λ unordered, shapes in the columns of x with
/// φᵀAφ = 1. Returns the valid lanes; in the others (A not positive definite beyond round-off, numbers not finite) λ is
/// 0 and the shapes are meaningless.
template <bool vectors, typename Size>
HWY_INLINE LaneMask modes_of_pack(Size n, const Pack* a, const Pack* k, PackOfModes<Size>& m) {
  constexpr int unchecked_turns = 2, most_turns = 14;
  const LaneMask definite = reduced<vectors>(n, a, k, m);
  for (int i = 0; i < unchecked_turns; ++i) turn<vectors, false>(n, m);
  for (int i = unchecked_turns; i < most_turns; ++i) {
    m.settled = hn::Le(turn<vectors, true>(n, m), all(0.0));
    if (hn::AllTrue(Lanes(), m.settled)) break;
  }
  if constexpr (vectors) {
    each(n, [&](int i) TRIVET_LANES {
      const Pack d = hn::Mul(m.weight[i], inverse_root(m.weight[i]));
      each(n, [&](int j) TRIVET_LANES { m.x[i * n + j] = hn::Mul(d, m.x[i * n + j]); });
    });
  }
  return definite;
}

/// Sorts λ ascending, and the shapes with them.
template <bool vectors, typename Size>
HWY_INLINE void sort(Size n, PackOfModes<Size>& m) {
  each(n, [&](int done) TRIVET_LANES {
    each(n, [&](int i) TRIVET_LANES {
      if (i + done >= n - 1) return;
      const Pack one = m.lambda[i], two = m.lambda[i + 1];
      m.lambda[i] = hn::Min(one, two);
      m.lambda[i + 1] = hn::Max(one, two);
      if constexpr (vectors) {
        const LaneMask keep = hn::Le(one, two);
        each(n, [&](int j) TRIVET_LANES {
          const Pack x = m.x[i * n + j], y = m.x[(i + 1) * n + j];
          m.x[i * n + j] = hn::IfThenElse(keep, x, y);
          m.x[(i + 1) * n + j] = hn::IfThenElse(keep, y, x);
        });
      }
    });
  });
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
