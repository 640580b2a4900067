// SPDX-License-Identifier: BSD-3-Clause
// All 2n roots of λ²A + λB + K + iD, each with its vector, for systems with loss factors (D) and for any load: under a
// complex load, or with D, residues do not come in conjugate pairs. Root k is found from mode k near +iΩ_k, root n + k
// near −iΩ_k as the conjugate of the root of λ²A + λB + K − iD near +iΩ_k. See rayleigh_iteration-inl.h for the
// iteration.
#if defined(TRIVET_NUMERICS_DRIVEN_POLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_DRIVEN_POLES_INL_H_
#undef TRIVET_NUMERICS_DRIVEN_POLES_INL_H_
#else
#define TRIVET_NUMERICS_DRIVEN_POLES_INL_H_
#endif

#include "trivet/numerics/roots/poles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

/// Real modes with their damping and loss, one design per lane.
template <typename Size>
struct LossyModalPack {
  static constexpr int triangle = Size::most * (Size::most + 1) / 2;
  Pack omega[Size::most];
  Pack b[triangle], d[triangle];  ///< ΦᵀBΦ, ΦᵀDΦ
  bool lossy, coupled;            ///< with a D; in some lane B̃ or D̃ is not diagonal
};

/// @param d  null without loss factors
template <typename Size>
HWY_INLINE void lossy_modal_pack(Size n, const PackOfModes<Size>& modes, const Pack* b, const Pack* d,
                                 LossyModalPack<Size>& result) {
  LaneMask coupled = in_modes(n, modes, b, result.b);
  if (d) coupled = hn::Or(coupled, in_modes(n, modes, d, result.d));
  else
    for (int entry = 0; entry < n * (n + 1) / 2; ++entry) result.d[entry] = all(0.0);
  result.lossy = d != nullptr;
  result.coupled = !hn::AllFalse(Lanes(), coupled);
  each(n, [&](int k) TRIVET_LANES { result.omega[k] = hn::Sqrt(modes.lambda[k]); });
}

/// Roots and vectors of a pack of designs, in the order of the modes.
template <typename Size>
struct DrivenPoles {
  ComplexPack lambda[2 * Size::most];
  ComplexPack v[2 * Size::most * Size::most];  ///< vector of root p in mode j at p n + j, length 1
  ComplexPack by_slope[2 * Size::most];        ///< 1 / vᵀM'(λ)v
  Pack condition;                              ///< largest |2λ| |v|²/|vᵀM'(λ)v|
  LaneMask good;  ///< all converged, far from each other found once: sums of λ, λ², 1/slope, λ/slope
};

/// Start of the root of λ² + λb + Ω² + id with Im λ ≥ 0, without cancellation: near iΩ, or real beyond critical
/// damping.
template <typename Size>
HWY_INLINE void lone_root(const Pack& omega, const Pack& b, const Pack& d, Pack& centre, Root<Size>& at) {
  const Pack half = hn::Mul(all(0.5), b), square = hn::Mul(half, half);
  const ComplexPack w = root({hn::Mul(hn::Sub(omega, half), hn::Add(omega, half)), d});
  const LaneMask heavy = hn::Gt(half, omega);
  const ComplexPack sum = {hn::Neg(hn::Add(half, w.im)), w.re}, other = {hn::Sub(w.im, half), hn::Neg(w.re)};
  const ComplexPack product = {hn::Mul(omega, omega), d};
  const ComplexPack far = select(hn::Lt(w.im, hn::Zero(Lanes())), divided(product, other), sum);
  const ComplexPack detuning = divided({hn::Neg(square), d}, {hn::Add(w.re, omega), w.im});
  const ComplexPack near = {hn::Neg(hn::Add(half, detuning.im)), detuning.re};
  centre = hn::IfThenZeroElse(heavy, omega);
  at.offset = select(heavy, far, near);
  at.slope = {hn::MulAdd(all(2.0), at.offset.re, b), hn::Mul(all(2.0), hn::Add(centre, at.offset.im))};
}

/// Stores the root of mode k.
/// @param mirrored  it is the conjugate of the root that was found
template <typename Size>
HWY_INLINE void store_root(Size n, const Root<Size>& at, const Pack& centre, int k, bool coupled, bool mirrored,
                           DrivenPoles<Size>& result) {
  const int pole = mirrored ? n + k : k;
  const auto turned = [&](const ComplexPack& z) TRIVET_LANES { return mirrored ? conjugate(z) : z; };
  result.lambda[pole] = turned({at.offset.re, hn::Add(centre, at.offset.im)});
  result.by_slope[pole] = turned(quick_inverse(at.slope));
  for (int j = 0; j < n; ++j) result.v[pole * n + j] = zero();
  if (coupled)
    for (int i = 0; i < n; ++i) result.v[pole * n + mode_order(i, k, n)] = turned(at.v[i]);
  else result.v[pole * n + k] = {all(1.0), all(0.0)};
  const Pack apart = hn::Mul(all(4.0), squared_modulus(result.lambda[pole]));
  result.condition = hn::Max(result.condition, hn::Div(apart, squared_modulus(at.slope)));  // squared, for now
}

/// Lanes in which each root was found once, except for one that nearly equals another. Without viscous damping the
/// roots are ±λ: then the same mistake in both halves leaves the sums of odd powers right, and only Σλ² = tr B² − 2 tr
/// (Ω² + iD) shows it.
template <typename Size>
HWY_INLINE LaneMask found_once(Size n, const LossyModalPack<Size>& modal, const DrivenPoles<Size>& poles) {
  const Pack tolerance = all(1e-9);
  ComplexPack trace = zero(), squares = zero(), still = zero(), moving = zero();
  Pack size = all(0.0), squares_size = size, still_size = size, moving_size = size;
  for (int k = 0; k < n; ++k) {
    const Pack omega = modal.omega[k], d = modal.d[packed(k, k)];
    trace.re = hn::Add(trace.re, modal.b[packed(k, k)]);
    squares = squares + ComplexPack{hn::Mul(all(2.0), hn::Mul(omega, omega)), hn::Mul(all(2.0), d)};
    for (int j = 0; j < n; ++j) {
      const Pack b = modal.b[packed_of(k, j)];
      squares.re = hn::NegMulAdd(b, b, squares.re);
    }
  }
  for (int p = 0; p < 2 * n; ++p) {
    ComplexPack square = zero();
    each(n, [&](int j) TRIVET_LANES { square = add_product(square, poles.v[p * n + j], poles.v[p * n + j]); });
    const ComplexPack share = square * poles.by_slope[p], rate = share * poles.lambda[p];
    trace = trace + poles.lambda[p];
    squares = squares + poles.lambda[p] * poles.lambda[p];
    squares_size = hn::Add(squares_size, squared_modulus(poles.lambda[p]));
    still = still + share;
    moving = moving + rate;
    size = hn::Add(size, one_norm(poles.lambda[p]));
    still_size = hn::Add(still_size, one_norm(share));
    moving_size = hn::Add(moving_size, one_norm(rate));
  }
  moving.re = hn::Sub(moving.re, all(static_cast<double>(n)));
  const auto small = [&](const ComplexPack& sum, const Pack& of)
                         TRIVET_LANES { return hn::Le(one_norm(sum), hn::Mul(tolerance, of)); };
  return hn::And(hn::And(small(trace, size), small(squares, squares_size)),
                 hn::And(small(still, still_size), small(moving, moving_size)));
}

/// Roots from the modes (good lanes need ω² > 0).
template <typename Size>
HWY_NOINLINE void driven_poles(Size n, const LossyModalPack<Size>& modal, DrivenPoles<Size>& result) {
  result.good = hn::Eq(all(0.0), all(0.0));
  result.condition = all(0.0);
  LaneMask any_real = hn::Lt(all(0.0), all(0.0));
  for (const bool mirrored : {false, true}) {
    const bool pairs = mirrored && !modal.lossy && hn::AllFalse(Lanes(), any_real);
    for (int k = 0; k < n; ++k) {
      if (pairs) {  // conjugates
        result.lambda[n + k] = conjugate(result.lambda[k]);
        result.by_slope[n + k] = conjugate(result.by_slope[k]);
        for (int j = 0; j < n; ++j) result.v[(n + k) * n + j] = conjugate(result.v[k * n + j]);
        continue;
      }
      Root<Size> at[1];
      Pencil<Size, true> pencil[1];
      Pack centre;
      const Pack own_loss = modal.d[packed(k, k)];
      lone_root(modal.omega[k], modal.b[packed(k, k)], mirrored ? hn::Neg(own_loss) : own_loss, centre, at[0]);
      any_real = hn::Or(any_real, hn::Eq(centre, hn::Zero(Lanes())));
      if (modal.coupled) {
        permute_to_mode(n, modal.omega, modal.b, k, centre, pencil[0]);
        for (int i = 0; i < n; ++i)
          for (int j = 0; j <= i; ++j) {
            const Pack d = modal.d[packed_of(mode_order(i, k, n), mode_order(j, k, n))];
            pencil[0].d[packed(i, j)] = mirrored ? hn::Neg(d) : d;
          }
        result.good = hn::And(result.good, converge(n, pencil, at));
      }
      store_root(n, at[0], centre, k, modal.coupled, mirrored, result);
    }
  }
  for (int k = 0; k < n; ++k) result.good = hn::And(result.good, hn::Lt(result.lambda[k].re, hn::Zero(Lanes())));
  result.good = hn::And(result.good, found_once(n, modal, result));
  result.condition = hn::Sqrt(result.condition);
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
