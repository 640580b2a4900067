// SPDX-License-Identifier: BSD-3-Clause
// Poles and residues of q(s) = Σ R_k/(s − λ_k) from real modes and modal damping, (λ² + λB̃ + Ω²) v = 0
// (rayleigh_iteration-inl.h).
#if defined(TRIVET_NUMERICS_POLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_POLES_INL_H_
#undef TRIVET_NUMERICS_POLES_INL_H_
#else
#define TRIVET_NUMERICS_POLES_INL_H_
#endif

#include "trivet/numerics/roots/rayleigh_iteration-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

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
  m.own = own;
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
