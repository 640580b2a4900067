// SPDX-License-Identifier: BSD-3-Clause
// All sign changes of the slopes of several |y|², one design per lane, with a proof: a walk along x = ω² in panels, on each of which
// f' is a polynomial p0 + p1 t + … + p4 t⁴ and a remainder that the distances of the poles bound. A panel is left behind when every curve's slope has
// no zero on it, or is monotonic with a known sign at its end, or the curve cannot matter there; otherwise it is made shorter.
#if defined(TRIVET_NUMERICS_AXIS_WALK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_AXIS_WALK_INL_H_
#undef TRIVET_NUMERICS_AXIS_WALK_INL_H_
#else
#define TRIVET_NUMERICS_AXIS_WALK_INL_H_
#endif

#include "trivet/numerics/found_extremum.h"
#include "trivet/numerics/squared_response-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

/// What of a walk is the same for all curves of a pack.
template <typename Size>
struct WalkedPack {
  PairPack z[most_pairs];     ///< poles in x
  LaneMask real[most_pairs];
  Size count;
  Pack from, to;              ///< of x; both finite
  LaneMask asked;             ///< lanes with good roots
};

/// One curve of a pack on the walk.
struct WalkedCurve {
  SquaredResponse f;
  Pack best;                  ///< highest value of f seen on the band
  Pack sign;                  ///< of the slope, last known: −1, 1, or 0
  // of the panel at hand
  Pack p0, p1, p2, rest;
  Pack most;                  ///< f is nowhere higher
  Pack after;                 ///< sign at its end; 0 if not known
};

/// 1/(x − z) and what follows from it at the middle of a panel.
struct PanelPowers {
  PairPack w[6];              ///< powers 1 … 6
  Pack plain, turned;         ///< bounds on the remainder: for C.first, and for C.second
};

constexpr double most_share = 0.43;   ///< of a panel's half width in the distance of its middle from the nearest pole
constexpr double least_share = 1e-5;  ///< where no sign can be told on shorter panels, the walk is given up
constexpr double narrowing = 0.7, widening = 1.12;
constexpr int most_steps = 2000;
constexpr double round_off = 1e-15;
constexpr double low_share = 0.01;    ///< of what a peak must rise by: a curve that is lower has no peak that counts
/// The remainder of f'' against that of f' over the half panel: its terms i ≥ 5 count i times, on average fewer than 6.5 times.
constexpr double slope_of_rest = 7;

/// Half width of the panel that starts at x so that it is `share` of the distance of its middle from the nearest pole; a little less by
/// (4a + 3b)/5 ≤ √(a² + b²).
template <typename Size>
HWY_INLINE Pack half_width(const WalkedPack<Size>& pack, const Pack& x, const Pack& share) {
  const Pack square = hn::Mul(share, share);
  Pack least = all(1e300);
  for (int k = 0; k < pack.count; ++k) {
    const Pack nearest = hn::IfThenElse(pack.real[k], hn::Max(pack.z[k].first, pack.z[k].second), pack.z[k].first);
    const Pack aside = hn::IfThenElse(pack.real[k], hn::Zero(Lanes()), hn::Mul(all(0.9), hn::Abs(pack.z[k].second)));
    const Pack ahead = hn::Sub(x, nearest), a = hn::Abs(ahead);
    const Pack large = hn::Max(a, aside), small = hn::Min(a, aside);
    const Pack distance = hn::Max(large, hn::MulAdd(all(0.8), large, hn::Mul(all(0.6), small)));
    least = hn::Min(least, hn::MulAdd(square, ahead, hn::Mul(share, distance)));
  }
  return hn::Div(least, hn::Sub(all(1.0), square));
}

template <typename Size>
HWY_INLINE void form_powers(const WalkedPack<Size>& pack, const Pack& centre, const Pack& half, PanelPowers* powers) {
  for (int k = 0; k < pack.count; ++k) {
    const LaneMask real = pack.real[k];
    PanelPowers& p = powers[k];
    const PairPack d = {hn::Sub(centre, pack.z[k].first), hn::IfThenElse(real, hn::Sub(centre, pack.z[k].second), hn::Neg(pack.z[k].second))};
    p.w[0] = inverse(real, d);
    p.w[1] = times(real, p.w[0], p.w[0]);
    p.w[2] = times(real, p.w[1], p.w[0]);
    p.w[3] = times(real, p.w[1], p.w[1]);
    p.w[4] = times(real, p.w[2], p.w[1]);
    p.w[5] = times(real, p.w[2], p.w[2]);
    // |w| from above: a + (√2 − 1) b ≥ √(a² + b²), b ≤ a
    const Pack re = hn::Abs(p.w[0].first), im = hn::Abs(p.w[0].second);
    const Pack modulus = hn::IfThenElse(real, re, hn::MulAdd(all(0.41422), hn::Min(re, im), hn::Max(re, im)));
    // Σ_{i ≥ 5} (i + 1) ρⁱ and Σ_{i ≥ 5} (i + 1)(i + 2) ρⁱ from above, ρ ≤ 0.47
    const auto fifth = [](const Pack& r) HWY_ATTR { return hn::Mul(hn::Mul(hn::Mul(r, r), hn::Mul(r, r)), r); };
    const auto tail = [&](const Pack& r) HWY_ATTR {
      return hn::Mul(fifth(r), hn::MulAdd(r, hn::MulAdd(r, hn::MulAdd(r, all(18.7), all(8.0)), all(7.0)), all(6.0)));
    };
    const Pack r = hn::Mul(half, modulus);
    p.plain = hn::Mul(hn::Mul(modulus, modulus), hn::Add(tail(r), all(round_off)));
    const Pack turned_tail = hn::Mul(fifth(r), hn::MulAdd(r, hn::MulAdd(r, hn::MulAdd(r, all(207.0), all(72.0)), all(56.0)), all(42.0)));
    // |Im wᵐ| ≤ m |Im w| |w|ᵐ⁻¹; of a real pair the second root on its own
    const Pack turned = hn::Mul(hn::Mul(modulus, im), hn::Add(turned_tail, all(2 * round_off)));
    const Pack second = hn::Mul(hn::Mul(im, im), hn::Add(tail(hn::Mul(half, im)), all(round_off)));
    p.turned = hn::IfThenElse(real, second, turned);
  }
}

struct WalkOptions {
  bool every_extremum = true;  ///< or only what can be the highest of its curve
  double matters = 1e-6;       ///< share of the highest amplitude that a peak must rise by
};

/// Slope of one curve on the panel at hand. @return lanes where nothing more is to be found out
template <typename Size>
HWY_INLINE LaneMask settle(const WalkedPack<Size>& pack, const PanelPowers* powers, const Pack& centre, const Pack& half, const WalkOptions& options,
                           WalkedCurve& curve) {
  const Pack zero = hn::Zero(Lanes());
  Pack value = hn::MulAdd(curve.f.slope, centre, curve.f.constant), s0 = zero, s1 = zero, s2 = zero, s3 = zero, s4 = zero, rest = zero;
  for (int k = 0; k < pack.count; ++k) {
    const PairPack C = curve.f.C[k];
    const PanelPowers& p = powers[k];
    value = hn::MulAdd(C.first, p.w[0].first, hn::MulAdd(C.second, p.w[0].second, value));
    s0 = hn::MulAdd(C.first, p.w[1].first, hn::MulAdd(C.second, p.w[1].second, s0));
    s1 = hn::MulAdd(C.first, p.w[2].first, hn::MulAdd(C.second, p.w[2].second, s1));
    s2 = hn::MulAdd(C.first, p.w[3].first, hn::MulAdd(C.second, p.w[3].second, s2));
    s3 = hn::MulAdd(C.first, p.w[4].first, hn::MulAdd(C.second, p.w[4].second, s3));
    s4 = hn::MulAdd(C.first, p.w[5].first, hn::MulAdd(C.second, p.w[5].second, s4));
    rest = hn::MulAdd(hn::Abs(C.first), p.plain, hn::MulAdd(hn::Abs(C.second), p.turned, rest));
  }
  const Pack p0 = hn::Sub(curve.f.slope, s0), p1 = hn::Add(s1, s1), p2 = hn::Mul(all(-3.0), s2);
  const Pack square = hn::Mul(half, half), linear = hn::Mul(half, p1), bent = hn::Mul(square, p2);
  const Pack cubic = hn::Mul(hn::Mul(square, half), hn::Mul(all(4.0), s3)), quartic = hn::Mul(hn::Mul(square, square), hn::Mul(all(-5.0), s4));
  const Pack size0 = hn::Abs(p0), size1 = hn::Abs(linear), size2 = hn::Abs(bent), size3 = hn::Abs(cubic), size4 = hn::Abs(quartic);
  const Pack others = hn::Add(hn::Add(size3, size4), rest);
  const Pack start = hn::Add(hn::Sub(p0, linear), bent), end = hn::Add(hn::Add(p0, linear), bent);
  // The parabola keeps its distance from 0 at both ends and, where it lies between, at its vertex.
  const Pack upright = hn::CopySign(all(1.0), p0);
  const LaneMask ends = hn::Gt(hn::Min(hn::Mul(upright, start), hn::Mul(upright, end)), others);
  const LaneMask vertex = hn::Or(hn::Or(hn::Ge(size1, hn::Add(size2, size2)), hn::Le(hn::Mul(p0, bent), zero)),
                                 hn::Gt(hn::Mul(hn::Mul(all(4.0), hn::Sub(size0, others)), size2), hn::Mul(size1, size1)));
  const LaneMask steady = hn::And(hn::And(ends, vertex), hn::Gt(size0, others));
  const Pack bends = hn::MulAdd(all(2.0), size2, hn::MulAdd(all(3.0), size3, hn::Mul(all(4.0), size4)));
  const LaneMask monotonic = hn::Gt(size1, hn::MulAdd(all(slope_of_rest), rest, bends));
  const Pack at_end = hn::Add(end, hn::Add(cubic, quartic));
  // A coordinate that nothing moves has nothing to find.
  const LaneMask at_rest = hn::And(hn::Eq(value, zero), hn::Eq(hn::Add(hn::Add(size0, size1), hn::Add(size2, others)), zero));
  const LaneMask turns = hn::Or(steady, hn::And(monotonic, hn::Gt(hn::Abs(at_end), rest))), known = hn::Or(turns, at_rest);
  curve.p0 = p0, curve.p1 = p1, curve.p2 = p2, curve.rest = others;
  curve.after = hn::IfThenElseZero(turns, hn::CopySign(all(1.0), at_end));
  const Pack swing = hn::Mul(half, hn::Add(hn::Add(size0, others), hn::MulAdd(all(0.5), size1, hn::Mul(all(1.0 / 3), size2))));
  curve.most = hn::Add(value, swing);
  if (!options.every_extremum) return hn::Or(known, hn::Lt(curve.most, hn::Mul(all(1 - 1e-13), curve.best)));
  // So low that no peak is there, or so flat that none is hidden. (The slope of |y|² is 2|y| times that of |y|.)
  constexpr double flat_share = 0.03, flat_top = 1e-10;
  const Pack matters = hn::Mul(all(options.matters * options.matters), curve.best), change = hn::Add(swing, swing);
  const LaneMask low = hn::Lt(curve.most, hn::Mul(all(low_share * low_share), matters));
  const LaneMask flat = hn::And(hn::Lt(hn::Mul(change, change), hn::Mul(hn::Mul(all(flat_share * flat_share), matters), hn::Sub(value, swing))),
                                hn::Lt(change, hn::Mul(all(flat_top), curve.best)));
  return hn::Or(known, hn::Or(low, flat));
}

/// Where the sign has changed on a panel that is left behind.
HWY_INLINE void note_change(const WalkedCurve& curve, const LaneMask& left, const Pack& centre, const Pack& half, bool every, int channel,
                            FoundExtrema& found) {
  const Pack zero = hn::Zero(Lanes());
  const Pack linear = hn::Mul(half, curve.p1), bent = hn::Mul(half, hn::Mul(half, curve.p2));
  LaneMask changed = hn::And(left, hn::Lt(hn::Mul(curve.sign, curve.after), zero));
  if (!every) {
    // What was passed by as too low leaves no sign: then that at the start of the panel counts.
    const Pack start = hn::Sub(hn::Add(curve.p0, bent), linear);
    const LaneMask rising = hn::Or(hn::Gt(curve.sign, zero), hn::And(hn::Eq(curve.sign, zero), hn::Gt(start, hn::Neg(curve.rest))));
    changed = hn::And(hn::And(left, rising), hn::And(hn::Lt(curve.after, zero), hn::Ge(curve.most, hn::Mul(all(1 - 1e-13), curve.best))));
  }
  if (hn::AllFalse(Lanes(), changed)) return;
  const Pack first = hn::Neg(hn::Div(curve.p0, curve.p1));
  const Pack second = hn::Neg(hn::Div(hn::MulAdd(hn::Mul(curve.p2, first), first, curve.p0), curve.p1));
  const Pack root = hn::Max(hn::Neg(half), hn::Min(half, second));
  HWY_ALIGN double at[8], lower[8], upper[8], after[8], flags[8];
  hn::Store(hn::Add(centre, root), Lanes(), at);
  hn::Store(hn::Sub(centre, half), Lanes(), lower);
  hn::Store(hn::Add(centre, half), Lanes(), upper);
  hn::Store(curve.after, Lanes(), after);
  hn::Store(hn::IfThenElseZero(changed, all(1.0)), Lanes(), flags);
  for (int lane = 0; lane < lane_count(); ++lane)
    if (flags[lane] != 0) found.push_back({lane, channel, at[lane], lower[lane], upper[lane], after[lane] < 0});
}

/// The next place where it pays to look again when only the highest values are asked: some widths of a resonance before or behind it.
template <typename Size>
HWY_INLINE Pack next_stop(const WalkedPack<Size>& pack, const Pack& x) {
  constexpr double widths = 6;
  Pack stop = pack.to;
  for (int k = 0; k < pack.count; ++k) {
    const Pack aside = hn::Mul(all(widths), hn::Abs(pack.z[k].second));
    for (const Pack& at : {hn::Sub(pack.z[k].first, aside), hn::Add(pack.z[k].first, aside)})
      stop = hn::IfThenElse(hn::AndNot(pack.real[k], hn::And(hn::Gt(at, x), hn::Lt(at, stop))), at, stop);
  }
  return stop;
}

/// Lanes where every curve stays below its best value between x and `stop`, by the distances of the poles alone.
template <typename Size>
HWY_INLINE LaneMask stays_below(const WalkedPack<Size>& pack, const WalkedCurve* curves, int channels, const Pack& x, const Pack& stop) {
  PairPack most[most_pairs];
  for (int k = 0; k < pack.count; ++k) {
    const LaneMask real = pack.real[k];
    const Pack a = pack.z[k].first, b = hn::Abs(pack.z[k].second);
    const Pack away = hn::Max(hn::Zero(Lanes()), hn::Max(hn::Sub(x, a), hn::Sub(a, stop)));
    const Pack inverse_square = hn::Div(all(1.0), hn::IfThenElse(real, hn::Sub(x, a), hn::MulAdd(away, away, hn::Mul(b, b))));
    const Pack distance = hn::MulAdd(all(0.41422), hn::Min(away, b), hn::Max(away, b));
    most[k] = {hn::IfThenElse(real, inverse_square, hn::Mul(distance, inverse_square)), hn::Mul(b, inverse_square)};
    if (!hn::AllFalse(Lanes(), real)) most[k].second = hn::IfThenElse(real, hn::Div(all(1.0), hn::Sub(x, pack.z[k].second)), most[k].second);
  }
  LaneMask below = hn::Eq(x, x);
  for (int c = 0; c < channels && !hn::AllFalse(Lanes(), below); ++c) {
    const SquaredResponse& f = curves[c].f;
    Pack value = hn::MulAdd(hn::Abs(f.slope), stop, hn::Abs(f.constant));
    for (int k = 0; k < pack.count; ++k)
      value = hn::MulAdd(hn::Abs(f.C[k].first), most[k].first, hn::MulAdd(hn::Abs(f.C[k].second), most[k].second, value));
    below = hn::And(below, hn::Lt(value, hn::Mul(all(1 - 1e-13), curves[c].best)));
  }
  return below;
}

/// @return lanes whose walk came to its end
template <typename Size>
HWY_INLINE LaneMask walk(const WalkedPack<Size>& pack, WalkedCurve* curves, int channels, const WalkOptions& options, FoundExtrema& found) {
  PanelPowers powers[most_pairs];
  Pack x = pack.from, share = all(most_share);
  LaneMask live = hn::And(pack.asked, hn::Lt(x, pack.to)), failed = hn::Ne(x, x);
  for (int step = 0; step < most_steps && !hn::AllFalse(Lanes(), live); ++step) {
    if (!options.every_extremum) {
      const Pack stop = next_stop(pack, x);
      const LaneMask passed = hn::And(live, stays_below(pack, curves, channels, x, stop));
      x = hn::IfThenElse(passed, stop, x);
      for (int c = 0; c < channels; ++c) curves[c].sign = hn::IfThenZeroElse(passed, curves[c].sign);
      live = hn::And(live, hn::Lt(x, pack.to));
      if (hn::AllTrue(Lanes(), hn::Or(passed, hn::Not(live)))) continue;
    }
    const Pack remaining = hn::Mul(all(0.5), hn::Sub(pack.to, x)), possible = half_width(pack, x, share);
    const LaneMask last = hn::Ge(possible, remaining);
    const Pack half = hn::Min(possible, remaining), centre = hn::Add(x, half);
    form_powers(pack, centre, half, powers);
    LaneMask left = live;
    for (int c = 0; c < channels && !hn::AllFalse(Lanes(), left); ++c) left = hn::And(left, settle(pack, powers, centre, half, options, curves[c]));
    if (!hn::AllFalse(Lanes(), left))
      for (int c = 0; c < channels; ++c) {
        WalkedCurve& curve = curves[c];
        note_change(curve, left, centre, half, options.every_extremum, c, found);
        const LaneMask takes = options.every_extremum ? hn::And(left, hn::Ne(curve.after, hn::Zero(Lanes()))) : left;
        curve.sign = hn::IfThenElse(takes, curve.after, curve.sign);
      }
    x = hn::IfThenElse(left, hn::IfThenElse(last, pack.to, hn::Add(x, hn::Add(half, half))), x);
    share = hn::IfThenElse(left, hn::Min(hn::Mul(share, all(widening)), all(most_share)), hn::Mul(share, all(narrowing)));
    failed = hn::Or(failed, hn::And(live, hn::Lt(share, all(least_share))));
    live = hn::AndNot(failed, hn::And(live, hn::Lt(x, pack.to)));
  }
  return hn::And(pack.asked, hn::AndNot(failed, hn::Not(live)));
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
