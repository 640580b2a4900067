// SPDX-License-Identifier: BSD-3-Clause
// Finds and proves all sign changes of the slopes of several |y|², one design per lane, by a scan along x (ω² or ω) in
// panels. On each panel f' is a polynomial p0 + p1 t + … + p4 t⁴ plus a remainder bounded by the distances of the
// poles. A panel is done if every curve's slope has no zero on it, or is monotonic with a known sign at its end, or the
// curve cannot matter there; otherwise the panel is shortened.
#if defined(TRIVET_NUMERICS_AXIS_SCAN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_AXIS_SCAN_INL_H_
#undef TRIVET_NUMERICS_AXIS_SCAN_INL_H_
#else
#define TRIVET_NUMERICS_AXIS_SCAN_INL_H_
#endif

#include <bit>
#include <cassert>
#include <cstdint>

#include "trivet/numerics/batch/peak_request.h"
#include "trivet/numerics/batch/zones-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

/// Data of a scan that all curves of a pack share.
template <typename Size>
struct ScannedPack {
  SquarePoles<Size> poles;
  Pack from, to;    ///< range of x; both finite during the scan
  LaneMask wanted;  ///< lanes with good roots
  // if only the highest values are requested:
  Zones<Size> zones;
  LaneMask open[Size::most];  ///< zones in which some curve may exceed its best known value
};

/// One curve of a pack during the scan.
template <typename Size>
struct ScannedCurve {
  SquaredResponse<Size::most> f;
  Pack best;                      ///< highest value of f found on the band
  Pack sign;                      ///< last known sign of the slope: −1, 1, or 0
  Pack tail;                      ///< sign beyond the scan, up to x = ∞; 0 if there is none
  Pack covered_from, covered_to;  ///< range already known to have no value above `best`
  LaneMask open[Size::most];      ///< zones that may contain a higher value
  // of the current panel
  Pack p0, p1, p2;   ///< the slope is p0 + p1 (x − centre) + p2 (x − centre)² …
  Pack start, rest;  ///< slope at its start, and error bound of the slope
  Pack most;         ///< upper bound of f
  Pack after;        ///< sign of the slope at its end; 0 if unknown
};

/// Powers of 1/(x − z) at the middle of a panel, and bounds derived from them.
struct PanelPowers {
  PairPack w[6];       ///< powers 1 … 6
  Pack plain, turned;  ///< bounds on the remainder: for C.first, and for C.second
};

constexpr double most_share = 0.43;   ///< largest half width of a panel / distance of its middle from the nearest pole
constexpr double least_share = 1e-5;  ///< the scan fails if a sign needs shorter panels
constexpr double narrowing = 0.7, widening = 1.12;
constexpr int most_steps = 2000;
/// Of a sum of C wᵐ over all poles and of the polynomial built from it, relative to Σ |C| |w|ᵐ.
template <typename Size>
constexpr double round_off_of = Size::most > 12 ? 12e-15 : 6e-15;
constexpr double low_share = 0.01;  ///< share of the required rise of a peak: a lower curve has no peak that counts
constexpr double most_doubt = 0.2;  ///< the same share: below it, heights hidden by round-off are accepted
/// Ratio of the remainder of f'' to that of f' over half a panel: its terms i ≥ 5 count i times, on average less than
/// 6.5 times.
constexpr double slope_of_rest = 7;

/// Half width of the panel that starts at x: `share` of the distance of its middle from the nearest pole, slightly less
/// because (4a + 3b)/5 ≤ √(a² + b²).
template <typename Size>
HWY_NOINLINE Pack half_width(const SquarePoles<Size>& poles, const Pack& x, const Pack& share) {
  const Pack square = hn::Mul(share, share);
  // h = s |x + h − z| gives h = (s² a + s √(a² + (1 − s²) b²))/(1 − s²), a = x − Re z, b = Im z; √(1 − s²) ≥ 0.9.
  Pack least = all(1e300);
  each(poles.count, [&](int k) TRIVET_LANES {
    const Pack b = hn::Abs(poles.aside[k]),
               nearest = hn::IfThenElse(poles.real[k], hn::Add(poles.centre[k], b), poles.centre[k]);
    const Pack aside = hn::IfThenZeroElse(poles.real[k], hn::Mul(all(0.9), b));
    const Pack ahead = hn::Sub(x, nearest), a = hn::Abs(ahead);
    const Pack large = hn::Max(a, aside), small = hn::Min(a, aside);
    const Pack distance = hn::Max(large, hn::MulAdd(all(0.8), large, hn::Mul(all(0.6), small)));
    least = hn::Min(least, hn::MulAdd(square, ahead, hn::Mul(share, distance)));
  });
  return hn::Div(least, hn::Sub(all(1.0), square));
}

template <typename Size>
HWY_NOINLINE void form_powers(const SquarePoles<Size>& poles, const Pack& centre, const Pack& half,
                              PanelPowers* powers) {
  constexpr double round_off = round_off_of<Size>;
  each(poles.count, [&](int k) TRIVET_LANES {
    PanelPowers& p = powers[k];
    // 1/(x − z)² = Σ_i (−1)ⁱ (i + 1) wⁱ⁺² tⁱ hⁱ at x = centre + t h, w = 1/(centre − z): i ≤ 4 by powers of w, the
    // others are at most |w|² Σ_{i ≥ 5} (i + 1) ρⁱ, ρ = h |w|.
    p.w[0] = inverse_distance(poles, k, centre);
    const Pack unit_aside = hn::Mul(poles.unit[k], p.w[0].second);
    for (int m = 1; m < 6; ++m) p.w[m] = times_turned(p.w[m - 1], p.w[0], unit_aside);
    const Pack modulus = modulus_above(poles.real[k], p.w[0]), aside = hn::Abs(p.w[0].second),
               r = hn::Mul(half, modulus);
    // Upper bounds on Σ_{i ≥ 5} (i + 1) ρⁱ and Σ_{i ≥ 5} (i + 1)(i + 2) ρⁱ, ρ ≤ 0.47.
    const Pack square = hn::Mul(r, r), fifth = hn::Mul(hn::Mul(square, square), r);
    const Pack tail =
        hn::Mul(fifth, hn::MulAdd(r, hn::MulAdd(r, hn::MulAdd(r, all(18.7), all(8.0)), all(7.0)), all(6.0)));
    const Pack turned_tail =
        hn::Mul(fifth, hn::MulAdd(r, hn::MulAdd(r, hn::MulAdd(r, all(207.0), all(72.0)), all(56.0)), all(42.0)));
    p.plain = hn::Mul(hn::Mul(modulus, modulus), hn::Add(tail, all(round_off)));
    // The j component of wᵐ is at most m |b| |w|ᵐ⁻¹.
    p.turned = hn::Mul(hn::Mul(modulus, aside), hn::Add(turned_tail, all(2 * round_off)));
  });
}

struct ScanOptions {
  bool every_extremum = true;  ///< false: only those that can be the highest of their curve
  double matters = 1e-6;       ///< required rise of a peak, as a share of the highest amplitude
};

/// Lanes in which a curve is known to stay below its best value between x and `end`.
template <typename Size>
HWY_INLINE LaneMask covered_between(const Zones<Size>& zones, const LaneMask* shared, const ScannedCurve<Size>& curve,
                                    const Pack& x, const Pack& end) {
  LaneMask open = hn::Lt(x, x);
  each(zones.count, [&](int k) TRIVET_LANES { open = hn::Or(open, hn::And(shared[k], curve.open[k])); });
  return hn::Or(hn::Not(open), hn::And(hn::Ge(x, curve.covered_from), hn::Le(end, curve.covered_to)));
}

/// Lanes in which a change of |y|² is too small for a peak that counts. (The slope of |y|² is 2|y| times that of |y|.)
/// @param least  lowest value of |y|² nearby
HWY_INLINE LaneMask is_flat(const Pack& change, const Pack& least, const Pack& best, const ScanOptions& options) {
  constexpr double flat_share = 0.03, flat_top = 1e-10;
  const Pack matters = hn::Mul(all(flat_share * flat_share * options.matters * options.matters), best);
  return hn::And(hn::Lt(hn::Mul(change, change), hn::Mul(matters, least)),
                 hn::Lt(change, hn::Mul(all(flat_top), best)));
}

/// Slope of one curve on the current panel. @return lanes in which the panel is done for this curve
template <typename Size>
HWY_NOINLINE LaneMask bound_slope(const ScannedPack<Size>& pack, const PanelPowers* powers, const Pack& centre,
                                  const Pack& half, const ScanOptions& options, const LaneMask& covered,
                                  ScannedCurve<Size>& curve) {
  const Pack zero = hn::Zero(Lanes());
  Pack value = hn::MulAdd(curve.f.slope, centre, curve.f.constant), s0 = zero, s1 = zero, s2 = zero, s3 = zero,
       s4 = zero, rest = zero;
  each(pack.poles.count, [&](int k) TRIVET_LANES {
    const PairPack C = curve.f.C[k];
    const PanelPowers& p = powers[k];
    value = sum_of(C, p.w[0], value);
    s0 = sum_of(C, p.w[1], s0);
    s1 = sum_of(C, p.w[2], s1);
    s2 = sum_of(C, p.w[3], s2);
    s3 = sum_of(C, p.w[4], s3);
    s4 = sum_of(C, p.w[5], s4);
    rest = hn::MulAdd(hn::Abs(C.first), p.plain, hn::MulAdd(hn::Abs(C.second), p.turned, rest));
  });
  // The slope at x = centre + t h, |t| ≤ 1, is f'(x) = slope − Σ_k C_k/(x − z_k)² = Σ_{i ≤ 4} cᵢ tⁱ + rest,
  // cᵢ = −(−h)ⁱ (i + 1) Σ_k C_k w_kⁱ⁺², and half of its bend is p1 + …: p_i = cᵢ/hⁱ.
  const Pack square = hn::Mul(half, half);
  Pack c0 = hn::Sub(curve.f.slope, s0), p1 = hn::Add(s1, s1), p2 = hn::Mul(all(-3.0), s2), c1 = hn::Mul(half, p1),
       c2 = hn::Mul(square, p2);
  Pack c3 = hn::Mul(hn::Mul(square, half), hn::Mul(all(4.0), s3));
  if (curve.f.grows) {
    const Pack* g = curve.f.growth;
    const Pack bend = growth_bend_at(g, centre), third = growth_third_at(g, centre);
    value = hn::Add(value, growth_at(g, centre));
    c0 = hn::Add(c0, growth_slope_at(g, centre));
    p1 = hn::MulAdd(all(2.0), bend, p1);
    c1 = hn::Mul(half, p1);
    p2 = hn::MulAdd(all(3.0), third, p2);
    c2 = hn::Mul(square, p2);
    c3 = hn::MulAdd(hn::Mul(square, half), hn::Mul(all(4.0), g[2]), c3);
    rest = hn::MulAdd(all(round_off_of<Size>), growth_slope_at(curve.f.growth_parts, hn::Add(centre, half)), rest);
  }
  const Pack c4 = hn::Mul(hn::Mul(square, square), hn::Mul(all(-5.0), s4));
  // Bernstein coefficients: they bound the polynomial, and twice their differences bound its derivative.
  const Pack even = hn::Add(c0, c4), odd = hn::Add(c1, c3), middle = hn::Mul(all(0.5), hn::Sub(c1, c3)),
             ends = hn::Add(even, c2), inner = hn::Sub(c0, c4);
  const Pack b0 = hn::Sub(ends, odd), b1 = hn::Sub(inner, middle), b2 = hn::NegMulAdd(all(1.0 / 3), c2, even),
             b3 = hn::Add(inner, middle), b4 = hn::Add(ends, odd);
  const Pack lowest = hn::Min(hn::Min(hn::Min(b0, b1), hn::Min(b3, b4)), b2),
             highest = hn::Max(hn::Max(hn::Max(b0, b1), hn::Max(b3, b4)), b2);
  const LaneMask steady = hn::Gt(hn::Max(lowest, hn::Neg(highest)), rest);
  const Pack d0 = hn::Sub(b1, b0), d1 = hn::Sub(b2, b1), d2 = hn::Sub(b3, b2), d3 = hn::Sub(b4, b3);
  const Pack least_bend = hn::Min(hn::Min(d0, d1), hn::Min(d2, d3)),
             most_bend = hn::Max(hn::Max(d0, d1), hn::Max(d2, d3));
  const LaneMask monotonic = hn::Gt(hn::Max(least_bend, hn::Neg(most_bend)), hn::Mul(all(0.5 * slope_of_rest), rest));
  const LaneMask turns = hn::Or(steady, hn::And(monotonic, hn::Gt(hn::Abs(b4), rest)));
  curve.p0 = c0, curve.p1 = p1, curve.p2 = p2, curve.start = b0, curve.rest = rest;
  curve.after = hn::IfThenElseZero(turns, hn::CopySign(all(1.0), b4));
  const Pack swing = hn::Mul(half, hn::Add(rest, hn::Max(hn::Abs(lowest), hn::Abs(highest))));
  curve.most = hn::Add(value, swing);
  // A curve that is exactly zero has no extrema.
  const LaneMask known = hn::Or(turns, hn::And(hn::Eq(value, zero), hn::Eq(swing, zero)));
  if (!options.every_extremum) {
    curve.after = hn::IfThenZeroElse(covered, curve.after);
    curve.sign = hn::IfThenZeroElse(covered, curve.sign);
    return hn::Or(hn::Or(known, covered), hn::Lt(curve.most, hn::Mul(all(1 - 1e-13), curve.best)));
  }
  // Too low for a peak that counts, or too flat to hide one.
  const Pack matters = hn::Mul(all(options.matters * options.matters), curve.best);
  const LaneMask low = hn::Lt(curve.most, hn::Mul(all(low_share * low_share), matters));
  return hn::Or(known, hn::Or(low, is_flat(hn::Add(swing, swing), hn::Sub(value, swing), curve.best, options)));
}

/// Skips a panel that does not matter for a curve.
template <typename Size>
HWY_INLINE void skip_panel(ScannedCurve<Size>& curve) {
  curve.after = curve.sign = hn::Zero(Lanes());
}

/// Notes the sign changes on panels that are done.
template <typename Size>
HWY_NOINLINE void note_change(const ScannedCurve<Size>& curve, const LaneMask& left, const Pack& centre,
                              const Pack& half, bool every, int channel, FoundExtrema& found) {
  const Pack zero = hn::Zero(Lanes());
  LaneMask changed = hn::And(left, hn::Lt(hn::Mul(curve.sign, curve.after), zero));
  if (!every) {
    // After a skipped panel the sign is unknown: then the sign at the start of this panel counts.
    const LaneMask rising =
        hn::Or(hn::Gt(curve.sign, zero), hn::And(hn::Eq(curve.sign, zero), hn::Gt(curve.start, hn::Neg(curve.rest))));
    changed = hn::And(hn::And(left, rising),
                      hn::And(hn::Lt(curve.after, zero), hn::Ge(curve.most, hn::Mul(all(1 - 1e-13), curve.best))));
  }
  if (hn::AllFalse(Lanes(), changed)) return;
  // Root of p0 + p1 y + p2 y²: y₁ = −p0/p1, then y₂ = −(p0 + p2 y₁²)/p1, kept within the panel.
  const Pack first = hn::Neg(hn::Div(curve.p0, curve.p1));
  const Pack second = hn::Neg(hn::Div(hn::MulAdd(hn::Mul(curve.p2, first), first, curve.p0), curve.p1));
  const Pack root = hn::Max(hn::Neg(half), hn::Min(half, second));
  HWY_ALIGN double at[8], lower[8], upper[8], after[8];
  hn::Store(hn::Add(centre, root), Lanes(), at);
  hn::Store(hn::Sub(centre, half), Lanes(), lower);
  hn::Store(hn::Add(centre, half), Lanes(), upper);
  hn::Store(curve.after, Lanes(), after);
  std::uint8_t flags[8] = {};
  hn::StoreMaskBits(Lanes(), changed, flags);
  for (unsigned left_over = flags[0]; left_over != 0; left_over &= left_over - 1) {
    const int lane = std::countr_zero(left_over);
    assert(lane < lane_count() && lower[lane] <= upper[lane] && "a sign changes in a lane that exists");
    found.push_back({lane, channel, at[lane], lower[lane], upper[lane], after[lane] < 0});
  }
}

/// Next x worth a check if only the highest values are requested: some widths of a resonance before or after it.
template <typename Size>
HWY_NOINLINE Pack next_stop(const ScannedPack<Size>& pack, const Pack& x) {
  constexpr double widths = 6;
  const SquarePoles<Size>& poles = pack.poles;
  Pack stop = pack.to;
  each(poles.count, [&](int k) TRIVET_LANES {
    const Pack aside = hn::Mul(all(widths), hn::Abs(poles.aside[k]));
    for (const Pack& at : {hn::Sub(poles.centre[k], aside), hn::Add(poles.centre[k], aside)})
      stop = hn::IfThenElse(hn::AndNot(poles.real[k], hn::And(hn::Gt(at, x), hn::Lt(at, stop))), at, stop);
    stop = hn::IfThenElse(hn::Gt(pack.zones.to[k], x), hn::Min(stop, pack.zones.to[k]), stop);
  });
  return stop;
}

/// Lanes in which every curve stays below its best value between x and `stop`, proven by the distances of the poles
/// alone.
template <typename Size>
HWY_NOINLINE LaneMask stays_below(const ScannedPack<Size>& pack, const ScannedCurve<Size>* curves, int channels,
                                  const Pack& x, const Pack& stop) {
  const SquarePoles<Size>& poles = pack.poles;
  PairPack most[Size::most];  // |a| and |b| of 1/(x − z) = a + b j
  each(poles.count, [&](int k) TRIVET_LANES { most[k] = most_between(poles, k, x, stop); });
  LaneMask below = hn::Eq(x, x), shared[Size::most];
  shared_with(pack.zones, x, stop, shared);
  for (int c = 0; c < channels && !hn::AllFalse(Lanes(), below); ++c) {
    const SquaredResponse<Size::most>& f = curves[c].f;
    Pack value = hn::MulAdd(hn::Abs(f.slope), stop, hn::Abs(f.constant));
    if (f.grows) value = hn::Add(value, growth_at(f.growth_parts, stop));
    each(poles.count, [&](int k) TRIVET_LANES {
      value =
          hn::MulAdd(hn::Abs(f.C[k].first), most[k].first, hn::MulAdd(hn::Abs(f.C[k].second), most[k].second, value));
    });
    const LaneMask covered = covered_between(pack.zones, shared, curves[c], x, stop);
    below = hn::And(below, hn::Or(covered, hn::Lt(value, hn::Mul(all(1 - 1e-13), curves[c].best))));
  }
  return below;
}

/// Next x in an open zone.
template <typename Size>
HWY_INLINE Pack next_open(const ScannedPack<Size>& pack, const Pack& x) {
  Pack next = pack.to;
  each(pack.zones.count, [&](int k) TRIVET_LANES {
    const LaneMask ahead = hn::And(pack.open[k], hn::Gt(pack.zones.to[k], x));
    next = hn::IfThenElse(ahead, hn::Min(next, hn::Max(x, pack.zones.from[k])), next);
  });
  return next;
}

/// Moves x from stop to stop as long as no curve can exceed its best value there.
template <typename Size>
HWY_NOINLINE LaneMask skip_ahead(const ScannedPack<Size>& pack, ScannedCurve<Size>* curves, int channels, Pack& x,
                                 LaneMask live) {
  LaneMask skipping = live;
  while (!hn::AllFalse(Lanes(), skipping)) {
    const Pack open = next_open(pack, x);
    const LaneMask jumps = hn::And(skipping, hn::Gt(open, x));
    for (int c = 0; c < channels; ++c) curves[c].sign = hn::IfThenZeroElse(jumps, curves[c].sign);
    x = hn::IfThenElse(jumps, open, x);
    skipping = hn::And(skipping, hn::Lt(x, pack.to));
    if (hn::AllFalse(Lanes(), skipping)) break;
    const Pack stop = next_stop(pack, x);
    skipping = hn::And(skipping, stays_below(pack, curves, channels, x, stop));
    x = hn::IfThenElse(skipping, stop, x);
    for (int c = 0; c < channels; ++c) curves[c].sign = hn::IfThenZeroElse(skipping, curves[c].sign);
    skipping = hn::And(skipping, hn::Lt(x, pack.to));
  }
  return hn::And(live, hn::Lt(x, pack.to));
}

/// Scans the axis panel by panel. @return lanes in which the scan was completed
template <typename Size>
HWY_NOINLINE LaneMask scan(const ScannedPack<Size>& pack, ScannedCurve<Size>* curves, int channels,
                           const ScanOptions& options, FoundExtrema& found) {
  PanelPowers powers[Size::most];
  Pack x = pack.from, share = all(most_share);
  LaneMask live = hn::And(pack.wanted, hn::Lt(x, pack.to)), failed = hn::Ne(x, x);
  for (int step = 0; step < most_steps; ++step) {
    if (!options.every_extremum) live = skip_ahead(pack, curves, channels, x, live);
    if (hn::AllFalse(Lanes(), live)) break;
    const Pack remaining = hn::Mul(all(0.5), hn::Sub(pack.to, x)), possible = half_width(pack.poles, x, share);
    const LaneMask last = hn::Ge(possible, remaining);
    const Pack half = hn::Min(possible, remaining), centre = hn::Add(x, half);
    form_powers(pack.poles, centre, half, powers);
    LaneMask left = live, shared[Size::most], covered = failed;
    if (!options.every_extremum) shared_with(pack.zones, x, hn::Add(centre, half), shared);
    for (int c = 0; c < channels && !hn::AllFalse(Lanes(), left); ++c) {
      if (!options.every_extremum) covered = covered_between(pack.zones, shared, curves[c], x, hn::Add(centre, half));
      if (options.every_extremum || !hn::AllTrue(Lanes(), hn::Or(covered, hn::Not(live))))
        left = hn::And(left, bound_slope(pack, powers, centre, half, options, covered, curves[c]));
      else skip_panel(curves[c]);
    }
    if (!hn::AllFalse(Lanes(), left))
      for (int c = 0; c < channels; ++c) {
        ScannedCurve<Size>& curve = curves[c];
        note_change(curve, left, centre, half, options.every_extremum, c, found);
        const LaneMask updates = options.every_extremum ? hn::And(left, hn::Ne(curve.after, hn::Zero(Lanes()))) : left;
        curve.sign = hn::IfThenElse(updates, curve.after, curve.sign);
      }
    x = hn::IfThenElse(left, hn::IfThenElse(last, pack.to, hn::Add(x, hn::Add(half, half))), x);
    share =
        hn::IfThenElse(left, hn::Min(hn::Mul(share, all(widening)), all(most_share)), hn::Mul(share, all(narrowing)));
    failed = hn::Or(failed, hn::And(live, hn::Lt(share, all(least_share))));
    live = hn::AndNot(failed, hn::And(live, hn::Lt(x, pack.to)));
  }
  return hn::And(pack.wanted, hn::AndNot(failed, hn::Not(live)));
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
