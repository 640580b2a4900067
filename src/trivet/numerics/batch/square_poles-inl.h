// SPDX-License-Identifier: BSD-3-Clause
// |y|² of several designs, one per lane, as a function of x (ω² or ω): half of it is Σ_k C_k · 1/(x − z_k) + constant +
// slope x (+ growth, squared_response-inl.h). Values at a pair of poles form one number a + b j: j² = −1 for two
// conjugates a ± bi, j² = 1 for two real poles a ± b; so the same operations serve both kinds.
#if defined(TRIVET_NUMERICS_SQUARE_POLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_SQUARE_POLES_INL_H_
#undef TRIVET_NUMERICS_SQUARE_POLES_INL_H_
#else
#define TRIVET_NUMERICS_SQUARE_POLES_INL_H_
#endif

#include "trivet/numerics/batch/squared_response-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

/// Poles of |y|² in x.
template <typename Size>
struct SquarePoles {
  Size count;
  PairPack z[Size::most];  ///< real and imaginary part, or two real poles
  LaneMask real[Size::most];
  Pack centre[Size::most], aside[Size::most], unit[Size::most];  ///< a, b, j²
  bool any_real = false;
};

/// Sets the members that follow from `z` and `real`.
template <typename Size>
HWY_INLINE void place(SquarePoles<Size>& poles) {
  LaneMask any = hn::Lt(all(0.0), all(0.0));
  each(poles.count, [&](int k) TRIVET_LANES {
    const LaneMask real = poles.real[k];
    const Pack first = hn::Mul(all(0.5), poles.z[k].first), second = hn::Mul(all(0.5), poles.z[k].second);
    poles.centre[k] = hn::IfThenElse(real, hn::Add(first, second), poles.z[k].first);
    poles.aside[k] = hn::IfThenElse(real, hn::Sub(first, second), poles.z[k].second);
    poles.unit[k] = hn::IfThenElse(real, all(1.0), all(-1.0));
    any = hn::Or(any, real);
  });
  poles.any_real = !hn::AllFalse(Lanes(), any);
}

/// 1/(x − z_k)
template <typename Size>
HWY_INLINE PairPack inverse_distance(const SquarePoles<Size>& poles, int k, const Pack& x) {
  const Pack ahead = hn::Sub(x, poles.centre[k]), aside = poles.aside[k];
  Pack square = hn::MulAdd(ahead, ahead, hn::Mul(aside, aside));
  if (poles.any_real)
    square =
        hn::IfThenElse(poles.real[k], hn::Mul(hn::Sub(x, poles.z[k].first), hn::Sub(x, poles.z[k].second)), square);
  const Pack scale = reciprocal(square);
  return {hn::Mul(ahead, scale), hn::Mul(aside, scale)};
}

/// Product of two such numbers; `b_turned` is j² b.second.
HWY_INLINE PairPack times_turned(const PairPack& a, const PairPack& b, const Pack& b_turned) {
  return {hn::MulAdd(a.second, b_turned, hn::Mul(a.first, b.first)),
          hn::MulAdd(a.second, b.first, hn::Mul(a.first, b.second))};
}

/// Upper bound on the modulus: √(a² + b²), or the larger of |a ± b|.
HWY_INLINE Pack modulus_above(const LaneMask& real, const PairPack& a) {
  constexpr double root_of_two_less_one = 0.41422;
  const Pack first = hn::Abs(a.first), second = hn::Abs(a.second);
  return hn::MulAdd(hn::IfThenElse(real, all(1.0), all(root_of_two_less_one)), hn::Min(first, second),
                    hn::Max(first, second));
}

HWY_INLINE Pack sum_of(const PairPack& C, const PairPack& w, const Pack& others) {
  return hn::MulAdd(C.first, w.first, hn::MulAdd(C.second, w.second, others));
}

/// Sum of the moduli of all terms of f at x, to which the round-off of its value is proportional.
template <typename Size>
HWY_INLINE Pack sum_of_moduli(const SquarePoles<Size>& poles, const SquaredResponse<Size::most>& f, const Pack& x) {
  Pack sum = hn::MulAdd(f.slope_parts, x, f.constant_parts);
  if (f.grows) sum = hn::Add(sum, growth_at(f.growth_parts, x));
  each(poles.count,
       [&](int k) TRIVET_LANES { sum = hn::MulAdd(f.parts[k], sum_of_parts(inverse_distance(poles, k, x)), sum); });
  return sum;
}

/// A curve and its first three derivatives.
struct Slopes {
  Pack value, first, second, third;
};

template <typename Size>
HWY_INLINE Slopes slopes_at(const SquarePoles<Size>& poles, const SquaredResponse<Size::most>& f, const Pack& x) {
  Pack value = hn::MulAdd(f.slope, x, f.constant), s1 = hn::Zero(Lanes()), s2 = s1, s3 = s1;
  each(poles.count, [&](int k) TRIVET_LANES {
    const PairPack w = inverse_distance(poles, k, x), C = f.C[k];
    const Pack turned = hn::Mul(poles.unit[k], w.second);
    const PairPack w2 = times_turned(w, w, turned), w3 = times_turned(w2, w, turned), w4 = times_turned(w3, w, turned);
    value = sum_of(C, w, value);
    s1 = sum_of(C, w2, s1);
    s2 = sum_of(C, w3, s2);
    s3 = sum_of(C, w4, s3);
  });
  Slopes slopes{value, hn::Sub(f.slope, s1), hn::Add(s2, s2), hn::Mul(all(-6.0), s3)};
  if (f.grows) {
    slopes.value = hn::Add(slopes.value, growth_at(f.growth, x));
    slopes.first = hn::Add(slopes.first, growth_slope_at(f.growth, x));
    slopes.second = hn::MulAdd(all(2.0), growth_bend_at(f.growth, x), slopes.second);
    slopes.third = hn::MulAdd(all(6.0), growth_third_at(f.growth, x), slopes.third);
  }
  return slopes;
}

/// Halley's step towards f' = 0.
HWY_INLINE Pack step_to_extremum(const Slopes& s) {
  return hn::Div(hn::Mul(hn::Mul(all(-2.0), s.first), s.second),
                 hn::NegMulAdd(s.first, s.third, hn::Mul(all(2.0), hn::Mul(s.second, s.second))));
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
