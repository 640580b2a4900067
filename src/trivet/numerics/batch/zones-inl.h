// SPDX-License-Identifier: BSD-3-Clause
// Divides the axis x (ω² or ω) into zones, one around each pole, to find those in which a curve may reach its best
// known value: in most zones the distances of the poles alone exclude that.
#if defined(TRIVET_NUMERICS_ZONES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_ZONES_INL_H_
#undef TRIVET_NUMERICS_ZONES_INL_H_
#else
#define TRIVET_NUMERICS_ZONES_INL_H_
#endif

#include "trivet/numerics/batch/square_poles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

/// Zone k extends halfway to the next lower and halfway to the next higher pole; poles at one frequency have the same
/// zone.
template <typename Size>
struct Zones {
  Size count;
  Pack from[Size::most], to[Size::most];  ///< from > to: outside the band
};

template <typename Size>
HWY_INLINE void form_zones(const SquarePoles<Size>& poles, const Pack& from, const Pack& to, Zones<Size>& zones) {
  const Pack infinity = all(1e300);
  zones.count = poles.count;
  each(poles.count, [&](int k) TRIVET_LANES {
    const Pack own = poles.centre[k];
    Pack below = hn::Neg(infinity), above = infinity;
    each(poles.count, [&](int other) TRIVET_LANES {
      const Pack c = poles.centre[other];
      below = hn::IfThenElse(hn::Lt(c, own), hn::Max(below, c), below);
      above = hn::IfThenElse(hn::Gt(c, own), hn::Min(above, c), above);
    });
    zones.from[k] = hn::Max(from, hn::Mul(all(0.5), hn::Add(own, below)));
    zones.to[k] = hn::Min(to, hn::Mul(all(0.5), hn::Add(own, above)));
  });
}

/// Lanes in which zone k and the interval from x to `end` share more than a point, by zone.
template <typename Size>
HWY_INLINE void shared_with(const Zones<Size>& zones, const Pack& x, const Pack& end, LaneMask* shared) {
  each(zones.count,
       [&](int k) TRIVET_LANES { shared[k] = hn::And(hn::Lt(zones.from[k], end), hn::Gt(zones.to[k], x)); });
}

/// Largest |a| and |b| of 1/(x − z_k) = a + b j at a distance of at least `away` from a conjugate pair.
HWY_INLINE PairPack most_inverse_distance(const Pack& aside, const Pack& away) {
  const Pack b = hn::Abs(aside), square = hn::Mul(b, b), further = hn::Max(away, b);
  return {hn::Mul(further, reciprocal(hn::MulAdd(further, further, square))),
          hn::Mul(b, reciprocal(hn::MulAdd(away, away, square)))};
}

/// The same from x upwards, above two real poles.
HWY_INLINE PairPack most_inverse_distance_of_real(const Pack& first, const Pack& second, const Pack& x) {
  const Pack scale = all(0.5);
  const Pack one = reciprocal(hn::Sub(x, first)), other = reciprocal(hn::Sub(x, second));
  return {hn::Mul(scale, hn::Add(one, other)), hn::Abs(hn::Mul(scale, hn::Sub(one, other)))};
}

/// The same for pole k on an interval of the axis.
template <typename Size>
HWY_INLINE PairPack most_between(const SquarePoles<Size>& poles, int k, const Pack& from, const Pack& to) {
  const Pack c = poles.centre[k], away = hn::Max(hn::Max(hn::Sub(from, c), hn::Sub(c, to)), hn::Zero(Lanes()));
  const PairPack most = most_inverse_distance(poles.aside[k], away);
  if (!poles.any_real) return most;
  const PairPack of_real = most_inverse_distance_of_real(poles.z[k].first, poles.z[k].second, from);
  return {hn::IfThenElse(poles.real[k], of_real.first, most.first),
          hn::IfThenElse(poles.real[k], of_real.second, most.second)};
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
