// SPDX-License-Identifier: BSD-3-Clause
// Poles and residues of q(s) = Σ R_k/(s − λ_k) from real modes and modal damping, (λ² + λB̃ + Ω²) v = 0, by Rayleigh quotient iteration for symmetric
// quadratic problems: M(λ) u = M'(λ) v, λ from uᵀM(λ)u = 0; cubic. A root near iΩ_k is kept as i·centre + offset, so that Re λ has all its digits
// however light the damping: M is formed from differences of frequencies, never from differences of squares.
#if defined(TRIVET_NUMERICS_POLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_POLES_INL_H_
#undef TRIVET_NUMERICS_POLES_INL_H_
#else
#define TRIVET_NUMERICS_POLES_INL_H_
#endif

#include "trivet/numerics/modes-inl.h"

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
HWY_INLINE ComplexPack divided(const ComplexPack& a, const ComplexPack& b) { return a * inverse(b); }

/// √z with Re ≥ 0; finite and right to a few units for moderate z, also 0.
HWY_INLINE ComplexPack root(const ComplexPack& z) {
  const Pack modulus = hn::Sqrt(squared_modulus(z));
  const Pack larger = hn::Sqrt(hn::Mul(all(0.5), hn::Add(modulus, hn::Abs(z.re))));
  const Pack smaller = hn::IfThenElseZero(hn::Gt(larger, all(0.0)), hn::Div(hn::Mul(all(0.5), hn::Abs(z.im)), larger));
  const LaneMask right = hn::Ge(z.re, all(0.0));
  return {hn::IfThenElse(right, larger, smaller), hn::CopySign(hn::IfThenElse(right, smaller, larger), z.im)};
}

/// M(λ) = λ² + λB + Ω² as it looks from one root: λ = i centre + offset, the root's own mode last.
template <typename Size>
struct Pencil {
  Pack below[Size::most];  ///< centre − Ω_j
  Pack above[Size::most];  ///< centre + Ω_j
  Pack b[Size::most * (Size::most + 1) / 2];
  Pack centre;
};

template <typename Size>
struct Root {
  ComplexPack offset;
  ComplexPack v[Size::most];  ///< length 1
  ComplexPack slope;          ///< vᵀ M'(λ) v
  Pack turned;                ///< sin² of the angle between v and the one before
};

/// λ with its frequency rounded.
template <typename Size>
HWY_INLINE ComplexPack value(const Pencil<Size>& m, const ComplexPack& offset) { return {offset.re, hn::Add(m.centre, offset.im)}; }

/// λ² + Ω_j² + λB_jj without cancellation.
template <typename Size>
HWY_INLINE ComplexPack diagonal(const Pencil<Size>& m, const ComplexPack& offset, int j) {
  const Pack x = offset.re, y = hn::Add(m.centre, offset.im), b = m.b[packed(j, j)];
  const Pack difference = hn::Add(m.below[j], offset.im), sum = hn::Add(m.above[j], offset.im);
  return {hn::NegMulAdd(difference, sum, hn::Mul(x, hn::Add(x, b))), hn::Mul(y, hn::Add(hn::Add(x, x), b))};
}

/// B v
template <typename Size>
HWY_INLINE void damped(Size n, const Pencil<Size>& m, const ComplexPack* v, ComplexPack* result) {
  TRIVET_UNROLL
  for (int i = 0; i < n; ++i) {
    result[i] = m.b[packed(i, 0)] * v[0];
    TRIVET_UNROLL
    for (int j = 1; j < n; ++j) {
      const Pack b = m.b[i > j ? packed(i, j) : packed(j, i)];
      result[i] = add_product(result[i], b, v[j]);
    }
  }
}

/// From the root of the last diagonal entry: v is the last unit vector, turned towards each other mode as if that were the only one.
template <typename Size>
HWY_INLINE void start(Size n, const Pencil<Size>& m, const ComplexPack& offset, Root<Size>& at) {
  const ComplexPack lambda = value(m, offset);
  at.offset = offset;
  Pack length = all(1.0);
  TRIVET_UNROLL
  for (int j = 0; j < n - 1; ++j) {
    const ComplexPack entry = diagonal(m, offset, j), coupling = m.b[packed(n - 1, j)] * lambda, twice = coupling + coupling;
    const ComplexPack radical = root(add_product(twice * twice, entry, entry));
    const Pack same = hn::MulAdd(entry.re, radical.re, hn::Mul(entry.im, radical.im));  // the larger of entry ± radical
    const ComplexPack denominator = {hn::Add(entry.re, hn::Mul(hn::CopySign(all(1.0), same), radical.re)), hn::Add(entry.im, hn::Mul(hn::CopySign(all(1.0), same), radical.im))};
    const LaneMask apart = hn::Gt(one_norm(denominator), all(0.0));
    const ComplexPack turn = divided(twice, {hn::IfThenElse(apart, denominator.re, all(1.0)), denominator.im});
    at.v[j] = {hn::Neg(turn.re), hn::Neg(turn.im)};
    length = hn::Add(length, squared_modulus(turn));
  }
  const Pack scale = inverse_root(length);
  at.v[n - 1] = {all(1.0), all(0.0)};
  TRIVET_UNROLL
  for (int j = 0; j < n; ++j) at.v[j] = scale * at.v[j];
  ComplexPack bv[Size::most], square = zero(), middle = zero(), p = zero();
  damped(n, m, at.v, bv);
  TRIVET_UNROLL
  for (int j = 0; j < n; ++j) {
    const ComplexPack own = at.v[j] * at.v[j];
    square = square + own;
    middle = add_product(middle, at.v[j], bv[j]);
    ComplexPack entry = diagonal(m, offset, j);
    entry = entry - m.b[packed(j, j)] * lambda;
    p = add_product(p, own, entry);
  }
  p = add_product(p, lambda, middle);
  const ComplexPack slope = add_product(middle, lambda + lambda, square);
  const ComplexPack first = divided(p, slope), change = divided(p, subtract_product(slope, square, first));
  at.offset = at.offset - change;
}

/// One step of the iteration.
template <typename Size>
HWY_INLINE void step(Size n, const Pencil<Size>& m, Root<Size>& at) {
  const ComplexPack lambda = value(m, at.offset), twice = lambda + lambda;
  ComplexPack z[Size::most], l[Size::most * Size::most], by_pivot[Size::most], p = zero();
  damped(n, m, at.v, z);
  TRIVET_UNROLL
  for (int i = 0; i < n; ++i) {
    z[i] = add_product(z[i], twice, at.v[i]);
    ComplexPack row[Size::most], pivot = diagonal(m, at.offset, i);
    TRIVET_UNROLL
    for (int j = 0; j < i; ++j) {
      row[j] = m.b[packed(i, j)] * lambda;
      TRIVET_UNROLL
      for (int k = 0; k < j; ++k) row[j] = subtract_product(row[j], row[k], l[j * n + k]);
      l[i * n + j] = row[j] * by_pivot[j];
      pivot = subtract_product(pivot, row[j], l[i * n + j]);
      z[i] = subtract_product(z[i], l[i * n + j], z[j]);
    }
    const Pack least = hn::Mul(all(1e-60), hn::Mul(m.above[i], m.above[i]));  // λ may be a root to the last digit
    const LaneMask regular = hn::Gt(one_norm(pivot), least);
    pivot = {hn::IfThenElse(regular, pivot.re, least), hn::IfThenElseZero(regular, pivot.im)};
    by_pivot[i] = inverse(pivot);
    const ComplexPack scaled = z[i] * by_pivot[i];
    p = add_product(p, z[i], scaled);
  }
  ComplexPack u[Size::most];
  Pack length = all(0.0);
  TRIVET_UNROLL
  for (int i = n - 1; i >= 0; --i) {
    u[i] = z[i] * by_pivot[i];
    TRIVET_UNROLL
    for (int j = i + 1; j < n; ++j) u[i] = subtract_product(u[i], l[j * n + i], u[j]);
    length = hn::Add(length, squared_modulus(u[i]));
  }
  const Pack scale = inverse_root(length);
  ComplexPack square = zero(), middle = zero(), along = zero();
  TRIVET_UNROLL
  for (int i = 0; i < n; ++i) {
    u[i] = scale * u[i];
    along = add_product(along, {at.v[i].re, hn::Neg(at.v[i].im)}, u[i]);
    square = add_product(square, u[i], u[i]);
    at.v[i] = u[i];
  }
  damped(n, m, u, z);
  TRIVET_UNROLL
  for (int i = 0; i < n; ++i) middle = add_product(middle, u[i], z[i]);
  p = hn::Mul(scale, scale) * p;
  const ComplexPack slope = add_product(middle, twice, square);
  const ComplexPack first = divided(p, slope), change = divided(p, subtract_product(slope, square, first));
  at.offset = at.offset - change;
  at.slope = subtract_product(slope, change + change, square);
  at.turned = hn::Sub(all(1.0), squared_modulus(along));
}

/// Real modes with their damping and load, one design per lane.
template <typename Size>
struct ModalPack {
  Pack omega[Size::most];
  Pack b[Size::most * (Size::most + 1) / 2];  ///< ΦᵀBΦ; what lies between two modes and is round-off is 0
  Pack load[Size::most];                      ///< Φᵀh
  bool coupled;                               ///< in some lane B̃ is not diagonal
};

template <typename Size>
HWY_INLINE void in_modes(Size n, const PackOfModes<Size>& modes, const Pack* b, const Pack* h, ModalPack<Size>& result) {
  constexpr double round_off = 1e-26;  // squared
  LaneMask coupled = hn::Lt(all(0.0), all(0.0));
  TRIVET_UNROLL
  for (int k = 0; k < n; ++k) {
    const Pack* phi = modes.x + k * n;
    Pack product[Size::most], load = all(0.0);
    TRIVET_UNROLL
    for (int i = 0; i < n; ++i) {
      load = hn::MulAdd(phi[i], h[i], load);
      product[i] = hn::Mul(b[packed(i, 0)], phi[0]);
      TRIVET_UNROLL
      for (int j = 1; j < n; ++j) product[i] = hn::MulAdd(b[i > j ? packed(i, j) : packed(j, i)], phi[j], product[i]);
    }
    result.load[k] = load;
    result.omega[k] = hn::Sqrt(modes.lambda[k]);
    TRIVET_UNROLL
    for (int l = 0; l <= k; ++l) {
      Pack entry = hn::Mul(modes.x[l * n], product[0]);
      TRIVET_UNROLL
      for (int i = 1; i < n; ++i) entry = hn::MulAdd(modes.x[l * n + i], product[i], entry);
      result.b[packed(k, l)] = entry;
    }
    TRIVET_UNROLL
    for (int l = 0; l < k; ++l) {
      Pack& entry = result.b[packed(k, l)];
      const LaneMask matters = hn::Gt(hn::Mul(entry, entry), hn::Mul(all(round_off), hn::Mul(result.b[packed(k, k)], result.b[packed(l, l)])));
      entry = hn::IfThenElseZero(matters, entry);
      coupled = hn::Or(coupled, matters);
    }
  }
  result.coupled = !hn::AllFalse(Lanes(), coupled);
}

/// The order in which mode `own` sees all modes: the others, then itself.
HWY_INLINE int seen(int i, int own, int n) { return i == n - 1 ? own : i + (i >= own); }

template <typename Size>
HWY_INLINE void arrange(Size n, const ModalPack<Size>& modal, int own, const Pack& centre, Pencil<Size>& m) {
  m.centre = centre;
  for (int i = 0; i < n; ++i) {
    const int row = seen(i, own, n);
    m.below[i] = hn::Sub(centre, modal.omega[row]);
    m.above[i] = hn::Add(centre, modal.omega[row]);
    for (int j = 0; j <= i; ++j) {
      const int column = seen(j, own, n);
      m.b[packed(i, j)] = modal.b[row > column ? packed(row, column) : packed(column, row)];
    }
  }
}

/// From the root of the last diagonal entry until v settles in all lanes: a step that turns it by less than 1e-5 leaves the third power of that.
template <typename Size>
HWY_INLINE LaneMask converge(Size n, const Pencil<Size>& m, Root<Size>& at) {
  constexpr int most_steps = 6;
  constexpr double settled = 1e-10;
  start(n, m, ComplexPack(at.offset), at);
  for (int i = 0; i < most_steps; ++i) {
    step(n, m, at);
    if (hn::AllTrue(Lanes(), hn::Le(at.turned, all(settled)))) break;
  }
  return hn::Le(at.turned, all(settled));
}

/// Poles and residues of a pack of designs, one design per lane. Poles k and n + k belong to mode k.
template <typename Size>
struct PackOfPoles {
  ComplexPack lambda[2 * Size::most];                 ///< k: Im > 0, or the slower of two real ones; n + k: its conjugate, or the faster
  ComplexPack residue[2 * Size::most * Size::most];   ///< in coordinate j of pole p at p n + j
  ComplexPack driving[2 * Size::most];                ///< hᵀ residue
  LaneMask real[Size::most];                          ///< two real poles
  Pack condition;                                     ///< largest |2λ| |v|²/|vᵀM'(λ)v|: 1 where modes are apart, without bound where poles merge
  LaneMask good;                                      ///< all converged and found once: Σλ = −tr B̃, Π|λ|² = ΠΩ², hᵀΣR = 0, hᵀΣλR = hᵀA⁻¹h within 1e-9
};

/// Pole and residue from a converged root, or, without one, from mode k alone.
template <typename Size>
HWY_INLINE void pole_of_mode(Size n, const PackOfModes<Size>& modes, const ModalPack<Size>& modal, int k, const Pack& centre, const Root<Size>& at, int pole, PackOfPoles<Size>& result) {
  ComplexPack participation = zero(), *residue = result.residue + pole * n;
  if (modal.coupled) {
    TRIVET_UNROLL
    for (int j = 0; j < n; ++j) residue[j] = zero();
    for (int i = 0; i < n; ++i) {
      const int mode = seen(i, k, n);
      participation = add_product(participation, modal.load[mode], at.v[i]);
      TRIVET_UNROLL
      for (int j = 0; j < n; ++j) residue[j] = add_product(residue[j], modes.x[mode * n + j], at.v[i]);
    }
  } else {
    participation.re = modal.load[k];
    TRIVET_UNROLL
    for (int j = 0; j < n; ++j) residue[j] = {modes.x[k * n + j], all(0.0)};
  }
  const ComplexPack scale = divided(participation, at.slope);
  result.lambda[pole] = {at.offset.re, hn::Add(centre, at.offset.im)};
  result.driving[pole] = participation * scale;
  TRIVET_UNROLL
  for (int j = 0; j < n; ++j) residue[j] = scale * residue[j];
  const Pack apart = hn::Mul(all(4.0), squared_modulus(result.lambda[pole]));
  result.condition = hn::Max(result.condition, hn::Div(apart, squared_modulus(at.slope)));  // its square
}

/// Where the lane is not `real`: the conjugate of pole k as pole n + k.
template <typename Size>
HWY_INLINE void mirror(Size n, LaneMask real, int k, PackOfPoles<Size>& result) {
  const int to = n + k;
  result.lambda[to] = select(real, result.lambda[to], conjugate(result.lambda[k]));
  result.driving[to] = select(real, result.driving[to], conjugate(result.driving[k]));
  TRIVET_UNROLL
  for (int j = 0; j < n; ++j) result.residue[to * n + j] = select(real, result.residue[to * n + j], conjugate(result.residue[k * n + j]));
}

/// Each pole found once?
template <typename Size>
HWY_INLINE LaneMask complete(Size n, const ModalPack<Size>& modal, const PackOfPoles<Size>& poles) {
  Pack trace = all(0.0), damping = trace, product = all(1.0), energy = trace, sum = trace, size = trace, slope_sum = trace, slope_size = trace;
  TRIVET_UNROLL
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

/// Poles and residues from modes (ω² > 0 in lanes that shall be good), damping matrix (packed lower triangle) and real load.
template <typename Size>
HWY_INLINE void poles_of_pack(Size n, const PackOfModes<Size>& modes, const Pack* b, const Pack* h, PackOfPoles<Size>& result) {
  ModalPack<Size> modal;
  in_modes(n, modes, b, h, modal);
  const Pack nothing = all(0.0);
  result.good = hn::Eq(nothing, nothing);
  result.condition = nothing;
  for (int k = 0; k < n; ++k) {
    const Pack omega = modal.omega[k], damping = hn::Mul(all(0.5), modal.b[packed(k, k)]);
    const Pack difference = hn::Mul(hn::Sub(damping, omega), hn::Add(damping, omega)), radical = hn::Sqrt(hn::Abs(difference));
    const LaneMask real = result.real[k] = hn::Gt(difference, nothing);
    const Pack fast = hn::Neg(hn::Add(damping, radical)), slow = hn::Div(hn::Mul(omega, omega), fast);
    const Pack centre = hn::IfThenZeroElse(real, omega), detuning = hn::Neg(hn::Div(hn::Mul(damping, damping), hn::Add(radical, omega)));
    const int partners = hn::AllFalse(Lanes(), real) ? 1 : 2;
    for (int partner = 0; partner < partners; ++partner) {
      Root<Size> at;
      at.offset = {hn::IfThenElse(real, partner == 0 ? slow : fast, hn::Neg(damping)), hn::IfThenZeroElse(real, detuning)};
      at.slope = {hn::Mul(all(2.0), hn::Add(at.offset.re, damping)), hn::Mul(all(2.0), hn::Add(centre, at.offset.im))};
      if (modal.coupled) {
        Pencil<Size> pencil;
        arrange(n, modal, k, centre, pencil);
        result.good = hn::And(result.good, converge(n, pencil, at));
      }
      pole_of_mode(n, modes, modal, k, centre, at, partner * n + k, result);
    }
    if (partners == 1) {  // nothing to keep
      result.lambda[n + k] = result.driving[n + k] = zero();
      TRIVET_UNROLL
      for (int j = 0; j < n; ++j) result.residue[(n + k) * n + j] = zero();
    }
    mirror(n, real, k, result);
  }
  result.good = hn::And(result.good, complete(n, modal, result));
  result.condition = hn::Sqrt(result.condition);
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
