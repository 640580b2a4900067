// SPDX-License-Identifier: BSD-3-Clause
// Poles and residues of q(s) = Σ R_k/(s − λ_k) from real modes and modal damping, (λ² + λB̃ + Ω²) v = 0, by Rayleigh
// quotient iteration for symmetric quadratic problems: M(λ) u = M'(λ) v, λ from uᵀM(λ)u = 0; cubic convergence. A root
// near iΩ_k is stored as i·centre + offset, so that Re λ has all its digits with any light damping: M is formed from
// differences of frequencies, never from differences of squares.
#if defined(TRIVET_NUMERICS_POLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_POLES_INL_H_
#undef TRIVET_NUMERICS_POLES_INL_H_
#else
#define TRIVET_NUMERICS_POLES_INL_H_
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
    const Pack same = hn::CopySign(all(1.0), hn::MulAdd(entry[j].re, radical.re, hn::Mul(entry[j].im, radical.im)));
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

/// ΦᵀSΦ of a packed symmetric S; couplings of two modes that are round-off are 0.
/// @return lanes in which it is not diagonal
template <typename Size>
HWY_INLINE LaneMask in_modes(Size n, const PackOfModes<Size>& modes, const Pack* entries, Pack* result) {
  constexpr double round_off = 1e-26;  // squared
  LaneMask coupled = hn::Lt(all(0.0), all(0.0));
  each(n, [&](auto k) TRIVET_LANES {
    const Pack* phi = modes.x + k * n;
    Pack product[Size::most];
    each(n, [&](int i) TRIVET_LANES {
      product[i] = hn::Mul(entries[packed(i, 0)], phi[0]);
      each(Fixed<1>(), n,
           [&](int j) TRIVET_LANES { product[i] = hn::MulAdd(entries[packed_of(i, j)], phi[j], product[i]); });
    });
    each(after(k), [&](int l) TRIVET_LANES {
      Pack entry = hn::Mul(modes.x[l * n], product[0]);
      each(Fixed<1>(), n, [&](int i) TRIVET_LANES { entry = hn::MulAdd(modes.x[l * n + i], product[i], entry); });
      result[packed_of(k, l)] = entry;
    });
    each(k, [&](int l) TRIVET_LANES {
      Pack& entry = result[packed_of(k, l)];
      const LaneMask matters =
          hn::Gt(hn::Mul(entry, entry), hn::Mul(all(round_off), hn::Mul(result[packed(k, k)], result[packed(l, l)])));
      entry = hn::IfThenElseZero(matters, entry);
      coupled = hn::Or(coupled, matters);
    });
  });
  return coupled;
}

/// Φᵀh
template <typename Size>
HWY_INLINE void in_modes_of_vector(Size n, const PackOfModes<Size>& modes, const Pack* h, Pack* result) {
  each(n, [&](int k) TRIVET_LANES {
    const Pack* phi = modes.x + k * n;
    result[k] = hn::Mul(phi[0], h[0]);
    each(Fixed<1>(), n, [&](int i) TRIVET_LANES { result[k] = hn::MulAdd(phi[i], h[i], result[k]); });
  });
}

/// Real modes with their damping and load, one design per lane.
template <typename Size>
struct ModalPack {
  Pack omega[Size::most];
  Pack b[Size::most * (Size::most + 1) / 2];  ///< ΦᵀBΦ
  Pack load[Size::most];                      ///< Φᵀh
  bool coupled;                               ///< B̃ is not diagonal in some lane
};

template <typename Size>
HWY_INLINE void modal_pack(Size n, const PackOfModes<Size>& modes, const Pack* b, const Pack* h,
                           ModalPack<Size>& result) {
  result.coupled = !hn::AllFalse(Lanes(), in_modes(n, modes, b, result.b));
  in_modes_of_vector(n, modes, h, result.load);
  each(n, [&](int k) TRIVET_LANES { result.omega[k] = hn::Sqrt(modes.lambda[k]); });
}

/// Order of the modes for the root of mode `own`: the others, then itself.
HWY_INLINE int mode_order(int i, int own, int n) { return i == n - 1 ? own : i + (i >= own); }

template <typename Size, bool lossy>
HWY_INLINE void permute_to_mode(Size n, const Pack* omega, const Pack* b, int own, const Pack& centre,
                                Pencil<Size, lossy>& m) {
  m.centre = centre;
  for (int i = 0; i < n; ++i) {
    const int row = mode_order(i, own, n);
    m.below[i] = hn::Sub(centre, omega[row]);
    m.above[i] = hn::Add(centre, omega[row]);
    for (int j = 0; j <= i; ++j) m.b[packed(i, j)] = b[packed_of(row, mode_order(j, own, n))];
  }
}

/// Poles and residues of a pack of designs, one design per lane. Poles k and n + k belong to mode k.
template <typename Size>
struct PackOfPoles {
  ComplexPack
      lambda[2 * Size::most];  ///< k: Im > 0, or the slower of two real ones; n + k: its conjugate, or the faster
  ComplexPack residue[2 * Size::most * Size::most];  ///< of pole p in coordinate j at p n + j
  ComplexPack driving[2 * Size::most];               ///< hᵀ residue
  LaneMask real[Size::most];                         ///< two real poles
  Pack condition;  ///< largest |2λ| |v|²/|vᵀM'(λ)v|: 1 for well-separated modes, unbounded if poles merge
  LaneMask good;   ///< all converged, each found once: Σλ = −tr B̃, Π|λ|² = ΠΩ², hᵀΣR = 0, hᵀΣλR = hᵀA⁻¹h within 1e-9
};

/// Pole and residue from a converged root, or from mode k alone if the modes are uncoupled.
template <typename Size>
HWY_INLINE void pole_of_mode(Size n, const PackOfModes<Size>& modes, const ModalPack<Size>& modal, int k,
                             const Pack& centre, const Root<Size>& at, int pole, PackOfPoles<Size>& result) {
  ComplexPack participation = zero(), *residue = result.residue + pole * n;
  if (modal.coupled) {
    each(n, [&](int j) TRIVET_LANES { residue[j] = zero(); });
    for (int i = 0; i < n; ++i) {
      const int mode = mode_order(i, k, n);
      participation = add_product(participation, modal.load[mode], at.v[i]);
      each(n, [&](int j) TRIVET_LANES { residue[j] = add_product(residue[j], modes.x[mode * n + j], at.v[i]); });
    }
  } else {
    participation.re = modal.load[k];
    each(n, [&](int j) TRIVET_LANES { residue[j] = {modes.x[k * n + j], all(0.0)}; });
  }
  const ComplexPack scale = divided(participation, at.slope);
  result.lambda[pole] = {at.offset.re, hn::Add(centre, at.offset.im)};
  result.driving[pole] = participation * scale;
  each(n, [&](int j) TRIVET_LANES { residue[j] = scale * residue[j]; });
  const Pack apart = hn::Mul(all(4.0), squared_modulus(result.lambda[pole]));
  result.condition = hn::Max(result.condition, hn::Div(apart, squared_modulus(at.slope)));  // squared, for now
}

/// Sets pole n + k to the conjugate of pole k in lanes without real poles.
template <typename Size>
HWY_INLINE void add_conjugates(Size n, int k, PackOfPoles<Size>& result) {
  const LaneMask real = result.real[k];
  const auto partner = [&](ComplexPack* of_poles, int to, int from) TRIVET_LANES {
    if (hn::AllFalse(Lanes(), real)) of_poles[to] = conjugate(of_poles[from]);
    else of_poles[to] = select(real, of_poles[to], conjugate(of_poles[from]));
  };
  partner(result.lambda, n + k, k);
  partner(result.driving, n + k, k);
  for (int j = 0; j < n; ++j) partner(result.residue, (n + k) * n + j, k * n + j);
}

/// Lanes in which each pole was found once.
template <typename Size>
HWY_INLINE LaneMask complete(Size n, const ModalPack<Size>& modal, const PackOfPoles<Size>& poles) {
  Pack trace = all(0.0), damping = trace, product = all(1.0), energy = trace, sum = trace, size = trace,
       slope_sum = trace, slope_size = trace;
  for (int k = 0; k < n; ++k) {
    const ComplexPack &one = poles.lambda[k], two = poles.lambda[n + k], *driving = poles.driving;
    damping = hn::Add(damping, modal.b[packed(k, k)]);
    trace = hn::Add(trace, hn::Add(one.re, two.re));
    const ComplexPack both = one * two;
    product = hn::Mul(product, hn::Div(both.re, hn::Mul(modal.omega[k], modal.omega[k])));
    energy = hn::MulAdd(modal.load[k], modal.load[k], energy);
    sum = hn::Add(sum, hn::Add(driving[k].re, driving[n + k].re));
    size = hn::Add(size, hn::Add(one_norm(driving[k]), one_norm(driving[n + k])));
    const ComplexPack first = one * driving[k], second = two * driving[n + k];
    slope_sum = hn::Add(slope_sum, hn::Add(first.re, second.re));
    slope_size = hn::Add(slope_size, hn::Add(one_norm(first), one_norm(second)));
  }
  const Pack tolerance = all(1e-9);
  LaneMask good = hn::Le(hn::Abs(hn::Add(trace, damping)), hn::Mul(tolerance, damping));
  good = hn::And(good, hn::Le(hn::Abs(hn::Sub(product, all(1.0))), tolerance));
  good = hn::And(good, hn::Le(hn::Abs(sum), hn::Mul(tolerance, size)));
  return hn::And(good, hn::Le(hn::Abs(hn::Sub(slope_sum, energy)), hn::Mul(tolerance, slope_size)));
}

/// Pole of mode k alone: the slower real one (or Im > 0), or its partner.
template <typename Size>
HWY_INLINE void uncoupled_pole(const ModalPack<Size>& modal, int k, bool partner, LaneMask& real, Pack& centre,
                               Root<Size>& at) {
  const Pack omega = modal.omega[k], damping = hn::Mul(all(0.5), modal.b[packed(k, k)]);
  const Pack difference = hn::Mul(hn::Sub(damping, omega), hn::Add(damping, omega)),
             radical = hn::Sqrt(hn::Abs(difference));
  real = hn::Gt(difference, all(0.0));
  centre = hn::IfThenZeroElse(real, omega);
  const Pack fast = hn::Neg(hn::Add(damping, radical)), slow = hn::Div(hn::Mul(omega, omega), fast);
  const Pack detuning = hn::Neg(hn::Div(hn::Mul(damping, damping), hn::Add(radical, omega)));
  at.offset = {hn::IfThenElse(real, partner ? fast : slow, hn::Neg(damping)), hn::IfThenZeroElse(real, detuning)};
  at.slope = {hn::Mul(all(2.0), hn::Add(at.offset.re, damping)), hn::Mul(all(2.0), hn::Add(centre, at.offset.im))};
}

/// Poles and residues from modes (good lanes need ω² > 0), damping matrix (packed lower triangle) and real load.
template <typename Size>
HWY_INLINE void poles_of_pack(Size n, const PackOfModes<Size>& modes, const Pack* b, const Pack* h,
                              PackOfPoles<Size>& result) {
  constexpr int together = Size::most % 2 == 0 && Size::most < 12 ? 2 : 1;
  ModalPack<Size> modal;
  modal_pack(n, modes, b, h, modal);
  result.good = hn::Eq(all(0.0), all(0.0));
  result.condition = all(0.0);
  LaneMask any_real = hn::Lt(all(0.0), all(0.0));
  for (int partner = 0; partner < 2; ++partner) {
    if (partner == 1 && hn::AllFalse(Lanes(), any_real)) break;
    for (int k = 0; k < n; k += together) {
      Root<Size> at[together];
      Pencil<Size> pencil[together];
      Pack centre[together];
      for (int r = 0; r < together; ++r) {
        uncoupled_pole(modal, k + r, partner == 1, result.real[k + r], centre[r], at[r]);
        any_real = hn::Or(any_real, result.real[k + r]);
        if (modal.coupled) permute_to_mode(n, modal.omega, modal.b, k + r, centre[r], pencil[r]);
      }
      if (modal.coupled) result.good = hn::And(result.good, converge(n, pencil, at));
      for (int r = 0; r < together; ++r)
        pole_of_mode(n, modes, modal, k + r, centre[r], at[r], partner * n + k + r, result);
    }
  }
  for (int k = 0; k < n; ++k) add_conjugates(n, k, result);
  result.good = hn::And(result.good, complete(n, modal, result));
  result.condition = hn::Sqrt(result.condition);
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
