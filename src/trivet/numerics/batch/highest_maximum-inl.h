// SPDX-License-Identifier: BSD-3-Clause
// Highest maximum of each |y|², found from its resonances, and the range around it in which nothing is higher. With y =
// x − x*, L the part of f from the pole next to x* and R the rest, f'(x*) = 0 gives
//   f − f* = (L − L* − L'* y) + (R − R* − R'* y) = −y² (α + β y)/D(x) + (≤ ½ max|R''| y²),
// D = |x − z|², β = L'*, α = L* + D'* L'*: f is not higher as long as (α − |β y|)/D exceeds ½ max|R''|. It must exceed
// it by a tenth of α/D: then a slope that is not exactly zero, with a Halley step that would change f by s, raises f by
// about 10 s at most.
#if defined(TRIVET_NUMERICS_HIGHEST_MAXIMUM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_HIGHEST_MAXIMUM_INL_H_
#undef TRIVET_NUMERICS_HIGHEST_MAXIMUM_INL_H_
#else
#define TRIVET_NUMERICS_HIGHEST_MAXIMUM_INL_H_
#endif

#include "trivet/numerics/batch/axis_scan-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

/// The highest of a curve's resonances.
struct Top {
  Pack at, value;
  Pack pole;         ///< pole of the resonance
  Pack away;         ///< distance from that pole on either side within which nothing is higher
  LaneMask settled;  ///< the slope is zero there within round-off, and the curve is lower in the covered range
};

/// The part of a curve from one of its poles, which differs from lane to lane.
struct Resonance {
  Pack pole, centre, aside, unit;
  PairPack C;
};

/// The resonance with the highest curve at the centre of its pole.
template <typename Size>
HWY_INLINE Resonance highest_resonance(const SquarePoles<Size>& poles, const SquaredResponse<Size::most>& f,
                                       const Pack* above_poles) {
  Resonance best{all(0.0), poles.centre[0], poles.aside[0], poles.unit[0], f.C[0]};
  Pack highest = above_poles[0];
  each(Fixed<1>(), poles.count, [&](int k) TRIVET_LANES {
    const LaneMask higher = hn::Gt(above_poles[k], highest);
    const auto choose = [&](Pack& old, const Pack& own) TRIVET_LANES { old = hn::IfThenElse(higher, own, old); };
    choose(highest, above_poles[k]);
    choose(best.pole, all(static_cast<double>(static_cast<int>(k))));
    choose(best.unit, poles.unit[k]);
    choose(best.centre, poles.centre[k]);
    choose(best.aside, poles.aside[k]);
    choose(best.C.first, f.C[k].first);
    choose(best.C.second, f.C[k].second);
  });
  return best;
}

/// Half the largest |R''| within `share` of the distance from x to the nearest other pole, and that range.
template <typename Size>
HWY_INLINE void bend_of_others(const SquarePoles<Size>& poles, const SquaredResponse<Size::most>& f,
                               const Resonance& own, const Pack& x, Pack& bend, Pack& range) {
  constexpr double share = 0.3, nearer = 1 / (0.7 * 0.7 * 0.7);
  Pack sum = hn::Zero(Lanes()), nearest = sum;
  each(poles.count, [&](int k) TRIVET_LANES {
    const LaneMask same = hn::Eq(own.pole, all(static_cast<double>(k)));
    const Pack modulus = hn::IfThenZeroElse(same, modulus_above(poles.real[k], inverse_distance(poles, k, x)));
    const Pack size = hn::Add(hn::Abs(f.C[k].first), hn::Abs(f.C[k].second));
    sum = hn::MulAdd(size, hn::Mul(modulus, hn::Mul(modulus, modulus)), sum);
    nearest = hn::Max(nearest, modulus);
  });
  bend = hn::Mul(all(nearer), sum);
  range = hn::Div(all(share), nearest);
  if (f.grows) bend = hn::Add(bend, growth_bend_at(f.growth_parts, hn::Add(x, range)));
}

/// @param above_poles  value of the curve at the centre of each pole (any low value for real poles)
template <typename Size>
HWY_NOINLINE Top find_top(const ScannedPack<Size>& pack, const Pack* above_poles, ScannedCurve<Size>& curve) {
  constexpr int steps = 3;
  constexpr double settled = 1e-11;  // slope × step, as a share of the value
  constexpr double off_centre = 3;   // search range of the top, in half widths of its pole
  const SquaredResponse<Size::most>& f = curve.f;
  const Resonance own = highest_resonance(pack.poles, f, above_poles);
  const Pack width = hn::Mul(all(off_centre), own.aside);
  const Pack from = hn::Max(pack.from, hn::Sub(own.centre, width)), to = hn::Min(pack.to, hn::Add(own.centre, width));
  Pack x = hn::Max(from, hn::Min(to, own.centre));
  Slopes s = slopes_at(pack.poles, f, x);
  Pack step = step_to_extremum(s);
  LaneMask converged;
  // Halley's steps on f'(x) = 0, kept within `off_centre` half widths of the resonance.
  for (int i = 0;; ++i) {
    converged = hn::Le(hn::Abs(hn::Mul(s.first, step)), hn::Mul(all(settled), s.value));
    if (i == steps || hn::AllTrue(Lanes(), hn::Or(converged, hn::Not(pack.wanted)))) break;
    x = hn::Max(from, hn::Min(to, hn::Add(x, step)));
    s = slopes_at(pack.poles, f, x);
    step = step_to_extremum(s);
  }
  Top top{x, s.value, own.pole, hn::Zero(Lanes()), hn::And(converged, hn::And(hn::Gt(x, from), hn::Lt(x, to)))};

  const Pack p = hn::Sub(x, own.centre), D = hn::MulAdd(p, p, hn::Mul(own.aside, own.aside)), twice = hn::Add(p, p);
  const Pack L = hn::Div(hn::MulAdd(own.C.first, p, hn::Mul(own.C.second, own.aside)), D);
  const Pack beta = hn::Div(hn::NegMulAdd(L, twice, own.C.first), D), alpha = hn::MulAdd(twice, beta, L);
  Pack bend, range;
  bend_of_others(pack.poles, f, own, x, bend, range);
  // Range allowed by D, with some reserve; then the condition is checked at its end, where D and |β y| are largest.
  constexpr double reserve = 0.7;
  const Pack allowed = hn::Sqrt(hn::Max(hn::Zero(Lanes()), hn::Mul(all(reserve), hn::Div(alpha, bend))));
  range = hn::Min(range, hn::Sub(allowed, hn::Abs(twice)));
  const Pack largest = hn::MulAdd(range, hn::Add(range, hn::Abs(twice)), D);
  const LaneMask complex = hn::Lt(own.unit, hn::Zero(Lanes()));
  constexpr double margin = 0.9;
  const LaneMask proven =
      hn::And(hn::And(complex, hn::Gt(range, hn::Zero(Lanes()))),
              hn::Gt(hn::NegMulAdd(hn::Abs(beta), range, hn::Mul(all(margin), alpha)), hn::Mul(bend, largest)));
  top.settled = hn::And(top.settled, proven);
  curve.covered_from = hn::IfThenElse(top.settled, hn::Sub(x, range), all(1.0));
  curve.covered_to = hn::IfThenElse(top.settled, hn::Add(x, range), all(-1.0));
  top.away = hn::IfThenElseZero(top.settled, hn::Max(hn::Zero(Lanes()), hn::Sub(range, hn::Abs(p))));
  curve.best = hn::Max(curve.best, s.value);
  return top;
}

/// Finds the zones in which a curve may exceed its best value: where the sum of the upper bounds of all pairs of poles
/// does.
template <typename Size>
HWY_NOINLINE void open_zones(ScannedPack<Size>& pack, const Top* tops, ScannedCurve<Size>* curves, int channels) {
  const SquarePoles<Size>& poles = pack.poles;
  const Zones<Size>& zones = pack.zones;
  const Pack zero = hn::Zero(Lanes());
  struct {
    PairPack most[Size::most];   // bounds of 1/(x − z)
    LaneMask right[Size::most];  // the zone is above that pole
    LaneMask crowded;            // another pole is in it
  } zone[Size::most];
  each(zones.count, [&](int m) TRIVET_LANES {
    zone[m].crowded = hn::Lt(zero, zero);
    each(poles.count, [&](int k) TRIVET_LANES {
      const Pack c = poles.centre[k], away = hn::Max(hn::Sub(zones.from[m], c), hn::Sub(c, zones.to[m]));
      zone[m].most[k] = most_between(poles, k, zones.from[m], zones.to[m]);
      zone[m].right[k] = hn::Ge(zones.from[m], c);
      if (k != m) zone[m].crowded = hn::Or(zone[m].crowded, hn::Le(away, zero));
    });
    pack.open[m] = hn::Lt(zero, zero);
  });
  for (int c = 0; c < channels; ++c) {
    ScannedCurve<Size>& curve = curves[c];
    const SquaredResponse<Size::most>& f = curve.f;
    Pack up[Size::most], down[Size::most], aside[Size::most];  // parts of C above a pole, below it, and for b
    each(poles.count, [&](int k) TRIVET_LANES {
      up[k] = hn::Max(f.C[k].first, zero);
      down[k] = hn::Max(hn::Neg(f.C[k].first), zero);
      aside[k] = hn::Max(hn::Mul(f.C[k].second, hn::CopySign(all(1.0), poles.aside[k])), zero);
    });
    const Pack highest = hn::Mul(all(1 - 1e-13), curve.best);
    each(zones.count, [&](int m) TRIVET_LANES {
      Pack one = hn::MulAdd(hn::Max(f.slope, zero), zones.to[m], f.constant), other = zero;
      if (f.grows) one = hn::Add(one, growth_at(f.growth_parts, zones.to[m]));
      each(poles.count, [&](int k) TRIVET_LANES {
        if (k == m) return;
        one = hn::MulAdd(hn::IfThenElse(zone[m].right[k], up[k], down[k]), zone[m].most[k].first, one);
        other = hn::MulAdd(aside[k], zone[m].most[k].second, other);
      });
      PairPack nearest = zone[m].most[m];
      const LaneMask at_top =
          hn::AndNot(poles.real[m], hn::Eq(tops[c].pole, all(static_cast<double>(static_cast<int>(m)))));
      if (!hn::AllFalse(Lanes(), at_top)) {
        const PairPack beyond = most_inverse_distance(poles.aside[m], tops[c].away);
        nearest = {hn::IfThenElse(at_top, beyond.first, nearest.first),
                   hn::IfThenElse(at_top, beyond.second, nearest.second)};
      }
      one = hn::MulAdd(hn::Max(up[m], down[m]), nearest.first, one);
      other = hn::MulAdd(aside[m], nearest.second, other);
      const LaneMask below = hn::Lt(hn::Add(one, other), highest), empty = hn::Ge(zones.from[m], zones.to[m]);
      curve.open[m] = hn::AndNot(empty, hn::Or(zone[m].crowded, hn::Not(below)));
      pack.open[m] = hn::Or(pack.open[m], curve.open[m]);
    });
  }
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
