// SPDX-License-Identifier: BSD-3-Clause
// Start of the last piece of the axis, on which no slope of several |y|² changes sign, one design per lane: in u = 1/x
// the rest of the axis is one panel.
#if defined(TRIVET_NUMERICS_AXIS_TAIL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_AXIS_TAIL_INL_H_
#undef TRIVET_NUMERICS_AXIS_TAIL_INL_H_
#else
#define TRIVET_NUMERICS_AXIS_TAIL_INL_H_
#endif

#include <cassert>
#include <memory>
#include <vector>

#include "trivet/foundation/index.h"
#include "trivet/numerics/batch/axis_scan-inl.h"
#include "trivet/numerics/batch/peak_request.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

/// Start x of the last piece of the axis, on which every slope keeps its sign up to x = ∞ or no peak that counts
/// remains. In u = 1/x a curve has the same form, with poles 1/z, and one panel extends from there to u = 0.
/// @param complete  reduced to the lanes in which this is proven
template <typename Size>
HWY_NOINLINE Pack beginning_of_tail(const ScannedPack<Size>& pack, ScannedCurve<Size>* curves,
                                    const std::vector<CurveEnds>& ends, const ScanOptions& options,
                                    LaneMask& complete) {
  constexpr int most_doublings = 40;
  const SquarePoles<Size>& poles = pack.poles;
  const auto channels = static_cast<int>(ends.size());
  ScannedPack<Size> inverted;
  inverted.poles = poles;
  inverted.wanted = pack.wanted;
  Pack begins = hn::Add(pack.from, pack.from);
  PairPack weight[Size::most];
  for (int k = 0; k < poles.count; ++k) {
    begins = hn::Max(begins, hn::Mul(all(2.0), hn::Add(hn::Abs(poles.centre[k]), hn::Abs(poles.aside[k]))));
    inverted.poles.z[k] = inverse(poles.real[k], poles.z[k]);
    weight[k] = all(-1.0) * times(poles.real[k], inverted.poles.z[k], inverted.poles.z[k]);
  }
  place(inverted.poles);
  const std::unique_ptr<ScannedCurve<Size>[]> inverted_curves(new ScannedCurve<Size>[to_size(channels)]);
  for (int c = 0; c < channels; ++c) {
    ScannedCurve<Size>& curve = inverted_curves[c];
    assert(!curves[c].f.grows && "curves with powers of x beyond 1 have a finite band");
    curve.f = curves[c].f;
    curve.best = curves[c].best;
    curve.sign = curves[c].sign;
    curve.f.slope = hn::Zero(Lanes());
    for (int k = 0; k < poles.count; ++k) {
      // C/(x − z) = C u/(1 − z u) = −C/z − (C/z²)/(u − 1/z) with u = 1/x.
      const LaneMask real = poles.real[k];
      const PairPack C = at_poles(real, curve.f.C[k]), part = times(real, C, inverted.poles.z[k]);
      curve.f.C[k] = for_half_sum(real, times(real, C, weight[k]));
      curve.f.constant = hn::Sub(curve.f.constant, half_sum(real, part));
    }
  }
  LaneMask settled = hn::Not(pack.wanted);
  for (int doubling = 0; doubling < most_doublings && !hn::AllTrue(Lanes(), settled); ++doubling) {
    if (doubling > 0) begins = hn::IfThenElse(settled, begins, hn::Add(begins, begins));
    PanelPowers powers[Size::most];
    const Pack half = hn::Div(all(0.5), begins);
    form_powers(inverted.poles, half, half, powers);
    LaneMask all_settled = hn::Eq(half, half);
    for (int c = 0; c < channels; ++c) {
      ScannedCurve<Size>& curve = inverted_curves[c];
      LaneMask own = bound_slope(inverted, powers, half, half, options, settled, curve);
      // Slopes that vanish at u = 0 keep their sign while they are monotonic.
      if (!ends[c].flat_at_infinity) {
        // The sign must be the same at u = 0, or the slope there so small that a turn before it cannot be seen.
        const Pack change = hn::Mul(hn::Mul(all(8.0), half), hn::Max(curve.rest, hn::Abs(curve.start)));
        own = hn::And(own,
                      hn::Or(hn::Or(hn::Eq(curve.after, hn::Zero(Lanes())),
                                    hn::Gt(hn::Mul(curve.start, curve.after), curve.rest)),
                             is_flat(change, curves[c].f.constant, curve.best, options)));
      }
      all_settled = hn::And(all_settled, own);
      curves[c].tail = hn::IfThenElse(settled, curves[c].tail, hn::Neg(curve.after));  // x decreases as u increases
    }
    settled = hn::Or(settled, all_settled);
  }
  complete = hn::And(complete, settled);
  return begins;
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
