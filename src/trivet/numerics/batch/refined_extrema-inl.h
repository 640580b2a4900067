// SPDX-License-Identifier: BSD-3-Clause
// Refines the extrema that the scan found in any lanes and curves, as many at once as there are lanes.
#if defined(TRIVET_NUMERICS_REFINED_EXTREMA_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_REFINED_EXTREMA_INL_H_
#undef TRIVET_NUMERICS_REFINED_EXTREMA_INL_H_
#else
#define TRIVET_NUMERICS_REFINED_EXTREMA_INL_H_
#endif

#include <algorithm>
#include <cassert>
#include <vector>

#include "trivet/foundation/index.h"
#include "trivet/numerics/batch/axis_scan-inl.h"
#include "trivet/numerics/batch/peak_request.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

/// Several curves, one per lane: |y|², and `plain`, x^−derivative of it before the derivatives, with less cancellation
/// at small x.
template <typename Size>
struct GatheredCurve {
  SquaredResponse<Size::most> f, plain;
  Pack derivative, round_off;
};

/// Data of all curves of all lanes, for extrema in any of them.
template <typename Size>
class LaneStore {
 public:
  LaneStore(const SquarePoles<Size>& poles, const ScannedCurve<Size>* curves, const std::vector<CurveEnds>& ends,
            const Pack& of_sums)
      : count_(poles.count),
        differentiated_(std::ranges::any_of(ends, [](const CurveEnds& of) { return of.powers_of_x > 0; })),
        grows_(std::any_of(curves, curves + ends.size(), [](const ScannedCurve<Size>& of) { return of.f.grows; })),
        of_channel_(to_size(3 * poles.count + 4 + (grows_ ? 6 : 0) + (differentiated_ ? 3 * poles.count + 1 : 0))),
        C_(ends.size() * of_channel_ * table_lanes) {
    hn::StoreU(of_sums, Lanes(), round_off_);
    for (int k = 0; k < count_; ++k) {
      hn::StoreU(poles.z[k].first, Lanes(), z_[k][0]);
      hn::StoreU(poles.z[k].second, Lanes(), z_[k][1]);
      hn::StoreU(hn::IfThenElseZero(poles.real[k], all(1.0)), Lanes(), real_[k]);
    }
    for (std::size_t c = 0; c < ends.size(); ++c) {
      double* to = C_.data() + c * of_channel_ * table_lanes;
      const auto keep = [&](const Pack& numbers) HWY_ATTR {
        hn::StoreU(numbers, Lanes(), to);
        to += table_lanes;
      };
      for (int k = 0; k < count_; ++k) {
        keep(curves[c].f.C[k].first);
        keep(curves[c].f.C[k].second);
        keep(curves[c].f.parts[k]);
      }
      keep(curves[c].f.constant);
      keep(curves[c].f.slope);
      keep(curves[c].f.constant_parts);
      keep(curves[c].f.slope_parts);
      for (int m = 0; grows_ && m < 3; ++m) {
        keep(curves[c].f.grows ? curves[c].f.growth[m] : hn::Zero(Lanes()));
        keep(curves[c].f.grows ? curves[c].f.growth_parts[m] : hn::Zero(Lanes()));
      }
      if (!differentiated_) continue;
      const int derivative = ends[c].powers_of_x;
      keep(all(derivative));
      for (int k = 0; k < count_; ++k) {
        PairPack C = at_poles(poles.real[k], curves[c].f.C[k]);
        Pack parts = curves[c].f.parts[k];
        for (int d = 0; d < derivative; ++d) {
          const PairPack by_z = inverse(poles.real[k], poles.z[k]);
          C = times(poles.real[k], C, by_z);
          parts = hn::Mul(parts, modulus_of(poles.real[k], by_z));
        }
        C = for_half_sum(poles.real[k], C);
        keep(C.first);
        keep(C.second);
        keep(parts);
      }
      assert(to == C_.data() + (c + 1) * of_channel_ * table_lanes && "each channel has the same room");
    }
  }

  /// Loads the curve of each extremum into its own lane; past the end, the last one is repeated.
  void gather(const FoundExtremum* found, int count, SquarePoles<Size>& poles, GatheredCurve<Size>& curve_of) const {
    assert(count > 0 && "lanes past the end repeat the last extremum");
    const hn::RebindToSigned<Lanes> integers;
    HWY_ALIGN std::int64_t lane[table_lanes], curve[table_lanes];
    for (int i = 0; i < lane_count(); ++i) {
      const FoundExtremum& e = found[std::min(i, count - 1)];
      lane[i] = e.lane;
      curve[i] = e.channel * static_cast<std::int64_t>(of_channel_) * table_lanes + e.lane;
    }
    const auto of_lane = hn::Load(integers, lane), of_curve = hn::Load(integers, curve);
    poles.count = count_;
    for (int k = 0; k < count_; ++k) {
      poles.z[k] = {hn::GatherIndex(Lanes(), z_[k][0], of_lane), hn::GatherIndex(Lanes(), z_[k][1], of_lane)};
      poles.real[k] = hn::Gt(hn::GatherIndex(Lanes(), real_[k], of_lane), hn::Zero(Lanes()));
    }
    place(poles);
    const auto number = [&](std::size_t row)
                            HWY_ATTR { return hn::GatherIndex(Lanes(), C_.data() + row * table_lanes, of_curve); };
    curve_of.round_off = hn::GatherIndex(Lanes(), round_off_, of_lane);
    const auto pairs = to_size(count_);
    SquaredResponse<Size::most>&f = curve_of.f, &plain = curve_of.plain;
    for (std::size_t k = 0; k < pairs; ++k) f.C[k] = {number(3 * k), number(3 * k + 1)}, f.parts[k] = number(3 * k + 2);
    f.constant = number(3 * pairs);
    f.slope = number(3 * pairs + 1);
    f.constant_parts = number(3 * pairs + 2);
    f.slope_parts = number(3 * pairs + 3);
    f.grows = grows_;
    for (std::size_t m = 0; grows_ && m < 3; ++m) {
      f.growth[m] = number(3 * pairs + 4 + 2 * m);
      f.growth_parts[m] = number(3 * pairs + 5 + 2 * m);
    }
    if (!differentiated_) return;
    const std::size_t from = 3 * pairs + (grows_ ? 10 : 4);
    curve_of.derivative = number(from);
    for (std::size_t k = 0; k < pairs; ++k) {
      plain.C[k] = {number(from + 1 + 3 * k), number(from + 2 + 3 * k)};
      plain.parts[k] = number(from + 3 + 3 * k);
    }
    plain.constant = plain.slope = plain.constant_parts = plain.slope_parts = hn::Zero(Lanes());
  }
  [[nodiscard]] bool differentiated() const { return differentiated_; }

 private:
  Size count_;
  bool differentiated_, grows_;
  std::size_t of_channel_;
  alignas(64) double z_[Size::most][2][table_lanes], real_[Size::most][table_lanes], round_off_[table_lanes];
  std::vector<double> C_;  ///< [channel][pairs with parts, constant and slope, their parts; if anything is
                           ///< differentiated: derivative, pairs with parts before it][lane]
};

/// Value and slopes of f = x^d g from those of g.
HWY_INLINE Slopes times_power(const Pack& d, const Pack& x, const Slopes& g) {
  const Pack one = all(1.0), x_if_squared = hn::IfThenElse(hn::Ge(d, all(2.0)), x, one);
  const Pack power = hn::Mul(hn::IfThenElse(hn::Ge(d, one), x, one), x_if_squared), rise = hn::Mul(d, x_if_squared),
             bend = hn::Mul(d, hn::Sub(d, one));
  const Pack twice = hn::Add(rise, rise), thrice = hn::Add(twice, rise);
  return {hn::Mul(power, g.value), hn::MulAdd(rise, g.value, hn::Mul(power, g.first)),
          hn::MulAdd(bend, g.value, hn::MulAdd(twice, g.first, hn::Mul(power, g.second))),
          hn::MulAdd(hn::Mul(all(3.0), bend), g.first, hn::MulAdd(thrice, g.second, hn::Mul(power, g.third)))};
}

/// Slopes at x and the moduli of the terms (for round-off), from the form with less cancellation there.
template <typename Size>
HWY_INLINE Slopes slopes_of(const SquarePoles<Size>& poles, const GatheredCurve<Size>& curve, bool differentiated,
                            const Pack& x, Pack& moduli) {
  Slopes s = slopes_at(poles, curve.f, x);
  moduli = sum_of_moduli(poles, curve.f, x);
  if (!differentiated) return s;
  const Pack zero = hn::Zero(Lanes()),
             of_plain =
                 times_power(curve.derivative, x, {sum_of_moduli(poles, curve.plain, x), zero, zero, zero}).value;
  const Slopes other = times_power(curve.derivative, x, slopes_at(poles, curve.plain, x));
  const LaneMask better = hn::Lt(of_plain, moduli);
  moduli = hn::Min(of_plain, moduli);
  return {hn::IfThenElse(better, other.value, s.value), hn::IfThenElse(better, other.first, s.first),
          hn::IfThenElse(better, other.second, s.second), hn::IfThenElse(better, other.third, s.third)};
}

/// Halley's steps on f' = 0 within the panels, as many extrema at once as there are lanes.
template <typename Size>
HWY_NOINLINE void refine(const LaneStore<Size>& store, FoundExtrema& found) {
  constexpr int steps_at_most = 4;
  constexpr double settled = 1e-13;
  SquarePoles<Size> poles;
  GatheredCurve<Size> curve;
  const auto count = static_cast<int>(found.size());
  for (int begin = 0; begin < count; begin += lane_count()) {
    FoundExtremum* e = found.data() + begin;
    const int taken = std::min(lane_count(), count - begin);
    store.gather(e, taken, poles, curve);
    alignas(64) double numbers[3][table_lanes];
    for (int i = 0; i < lane_count(); ++i) {
      const FoundExtremum& own = e[std::min(i, taken - 1)];
      numbers[0][i] = own.at, numbers[1][i] = own.lower, numbers[2][i] = own.upper;
    }
    Pack x = hn::LoadU(Lanes(), numbers[0]), missed;
    const Pack lower = hn::LoadU(Lanes(), numbers[1]), upper = hn::LoadU(Lanes(), numbers[2]);
    Pack moduli;
    Slopes s = slopes_of(poles, curve, store.differentiated(), x, moduli);
    for (int i = 0; i <= steps_at_most; ++i) {
      const Pack step = step_to_extremum(s);
      missed = hn::Abs(hn::Mul(s.first, step));
      if (i == steps_at_most || hn::AllTrue(Lanes(), hn::Le(missed, hn::Mul(all(settled), s.value)))) break;
      x = hn::Max(lower, hn::Min(upper, hn::Add(x, step)));
      s = slopes_of(poles, curve, store.differentiated(), x, moduli);
    }
    hn::StoreU(x, Lanes(), numbers[0]);
    hn::StoreU(s.value, Lanes(), numbers[1]);
    hn::StoreU(hn::MulAdd(curve.round_off, moduli, missed), Lanes(), numbers[2]);
    for (int i = 0; i < taken; ++i) e[i].at = numbers[0][i], e[i].value = numbers[1][i], e[i].missed = numbers[2][i];
  }
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
