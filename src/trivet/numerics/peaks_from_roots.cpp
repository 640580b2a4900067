// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/peaks_from_roots.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "trivet/numerics/axis_walk-inl.h"
#include "trivet/numerics/peak_count.h"
#include "trivet/numerics/root_table.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

HWY_INLINE Pack from_table(const double* row, int lane) { return hn::LoadU(Lanes(), row + lane); }

template <typename Size>
HWY_INLINE void see_values(const WalkedPack<Size>& pack, const Pack& x, WalkedCurve* curves, int channels, Pack* values) {
  PairPack w[most_pairs];
  for (int k = 0; k < pack.count; ++k)
    w[k] = inverse(pack.real[k], {hn::Sub(x, pack.z[k].first), hn::IfThenElse(pack.real[k], hn::Sub(x, pack.z[k].second), hn::Neg(pack.z[k].second))});
  for (int c = 0; c < channels; ++c) {
    Pack value = hn::MulAdd(curves[c].f.slope, x, curves[c].f.constant);
    for (int k = 0; k < pack.count; ++k)
      value = hn::MulAdd(curves[c].f.C[k].first, w[k].first, hn::MulAdd(curves[c].f.C[k].second, w[k].second, value));
    curves[c].best = hn::Max(curves[c].best, value);
    if (values) values[c] = value;
  }
}

/// Where the last piece of the axis begins, on which every slope keeps its sign to x = ∞ or nothing matters any more. In u = 1/x a curve has the
/// same form, with poles 1/z, and one panel reaches from there to u = 0.
/// @param complete  leaves the lanes where that is proven
template <typename Size>
HWY_INLINE Pack beginning_of_tail(const WalkedPack<Size>& pack, const WalkedCurve* curves, int channels, const PeakQuestion& question, const WalkOptions& options,
                                  LaneMask& complete) {
  constexpr int most_doublings = 40;
  WalkedPack<Size> inverted = pack;
  Pack begins = hn::Add(pack.from, pack.from);
  PairPack weight[most_pairs];
  for (int k = 0; k < pack.count; ++k) {
    const LaneMask real = pack.real[k];
    const Pack a = hn::Abs(pack.z[k].first), b = hn::Abs(pack.z[k].second);
    begins = hn::Max(begins, hn::Mul(all(2.0), hn::IfThenElse(real, hn::Max(a, b), hn::Add(a, b))));
    inverted.z[k] = inverse(real, pack.z[k]);
    weight[k] = all(-1.0) * times(real, inverted.z[k], inverted.z[k]);
  }
  WalkedCurve curve;
  for (int c = 0; c < channels; ++c) {
    const bool proper = question.rows[static_cast<std::size_t>(c)].on_velocity.size() == 0;
    curve = curves[c];
    curve.f.slope = hn::Zero(Lanes());
    for (int k = 0; k < pack.count; ++k) {
      const LaneMask real = pack.real[k];
      const PairPack C = {curve.f.C[k].first, hn::IfThenElse(real, curve.f.C[k].second, hn::Neg(curve.f.C[k].second))};
      const PairPack turned = times(real, C, weight[k]);
      const PairPack part = times(real, C, inverted.z[k]);
      curve.f.C[k] = {turned.first, hn::IfThenElse(real, turned.second, hn::Neg(turned.second))};
      curve.f.constant = hn::Sub(curve.f.constant, hn::Add(part.first, hn::IfThenElse(real, part.second, hn::Zero(Lanes()))));
    }
    // Slopes that vanish at u = 0 keep their sign while they are monotonic.
    const bool flat_at_infinity = proper && question.rows[static_cast<std::size_t>(c)].derivative == 0;
    LaneMask settled = hn::Not(pack.asked);
    for (int doubling = 0; doubling < most_doublings; ++doubling) {
      PanelPowers powers[most_pairs];
      const Pack half = hn::Div(all(0.5), begins);
      form_powers(inverted, half, half, powers);
      settled = settle(inverted, powers, half, half, options, curve);
      const Pack start = hn::Sub(hn::MulAdd(hn::Mul(half, half), curve.p2, curve.p0), hn::Mul(half, curve.p1));
      if (!flat_at_infinity) settled = hn::And(settled, hn::Or(hn::Eq(curve.after, hn::Zero(Lanes())), hn::Gt(hn::Mul(start, curve.after), curve.rest)));
      settled = hn::Or(settled, hn::Not(pack.asked));
      if (hn::AllTrue(Lanes(), settled)) break;
      begins = hn::IfThenElse(settled, begins, hn::Add(begins, begins));
    }
    complete = hn::And(complete, settled);
  }
  return begins;
}

/// Signs of the slopes where the walk begins; 0 where round-off hides them.
template <typename Size>
HWY_INLINE void first_signs(const WalkedPack<Size>& pack, WalkedCurve* curves, int channels, const PeakQuestion& question) {
  PanelPowers powers[most_pairs];
  form_powers(pack, pack.from, hn::Zero(Lanes()), powers);
  const WalkOptions options{false, 0};
  for (int c = 0; c < channels; ++c) {
    settle(pack, powers, pack.from, hn::Zero(Lanes()), options, curves[c]);
    curves[c].sign = curves[c].after;
    // |y|² begins like x^derivative at rest.
    if (question.from == 0 && question.rows[static_cast<std::size_t>(c)].derivative > 0) curves[c].sign = all(1.0);
  }
}

struct LaneStore {
  alignas(64) double z[most_pairs][2][table_lanes], real[most_pairs][table_lanes];
  std::vector<double> C;  ///< [channel][pair, constant and slope][2][lane]
  int pairs = 0;
  double* of(int channel, int pair, int part) { return C.data() + (((channel * (pairs + 1)) + pair) * 2 + part) * table_lanes; }
};

/// Halley's steps on f' = 0 within the panels, eight extrema at once.
HWY_INLINE void refine(LaneStore& store, FoundExtrema& found) {
  constexpr int steps = 4;
  const int lanes = lane_count(), n = store.pairs;
  const auto count = static_cast<int>(found.size());
  for (int begin = 0; begin < count; begin += lanes) {
    alignas(64) double z[most_pairs][2][table_lanes], C[most_pairs + 1][2][table_lanes], real[most_pairs][table_lanes], at[table_lanes], lower[table_lanes], upper[table_lanes];
    for (int i = 0; i < lanes; ++i) {
      const FoundExtremum& e = found[static_cast<std::size_t>(std::min(begin + i, count - 1))];
      for (int k = 0; k < n; ++k) {
        real[k][i] = store.real[k][e.lane];
        for (int part = 0; part < 2; ++part) z[k][part][i] = store.z[k][part][e.lane];
      }
      for (int k = 0; k <= n; ++k)
        for (int part = 0; part < 2; ++part) C[k][part][i] = store.of(e.channel, k, part)[e.lane];
      at[i] = e.at, lower[i] = e.lower, upper[i] = e.upper;
    }
    const Pack lowest = from_table(lower, 0), highest = from_table(upper, 0);
    const Pack constant = from_table(C[n][0], 0), slope = from_table(C[n][1], 0);
    Pack x = from_table(at, 0), value = constant, s0 = slope, missed = constant;
    for (int step = 0; step <= steps; ++step) {
      value = hn::MulAdd(slope, x, constant);
      Pack s1 = hn::Zero(Lanes()), s2 = s1;
      s0 = hn::Zero(Lanes());
      for (int k = 0; k < n; ++k) {
        const LaneMask pair = hn::Ne(from_table(real[k], 0), hn::Zero(Lanes()));
        const Pack z1 = from_table(z[k][0], 0), z2 = from_table(z[k][1], 0), C1 = from_table(C[k][0], 0), C2 = from_table(C[k][1], 0);
        const PairPack w = inverse(pair, {hn::Sub(x, z1), hn::IfThenElse(pair, hn::Sub(x, z2), hn::Neg(z2))});
        const PairPack w2 = times(pair, w, w), w3 = times(pair, w2, w), w4 = times(pair, w2, w2);
        value = hn::MulAdd(C1, w.first, hn::MulAdd(C2, w.second, value));
        s0 = hn::MulAdd(C1, w2.first, hn::MulAdd(C2, w2.second, s0));
        s1 = hn::MulAdd(C1, w3.first, hn::MulAdd(C2, w3.second, s1));
        s2 = hn::MulAdd(C1, w4.first, hn::MulAdd(C2, w4.second, s2));
      }
      // f' = slope − s0, f'' = 2 s1, f''' = −6 s2
      const Pack f1 = hn::Sub(slope, s0), f2 = hn::Add(s1, s1), f3 = hn::Mul(all(-6.0), s2);
      const Pack halley = hn::Div(hn::Mul(hn::Mul(all(2.0), f1), f2), hn::NegMulAdd(f1, f3, hn::Mul(all(2.0), hn::Mul(f2, f2))));
      missed = hn::Abs(hn::Mul(f1, halley));
      if (step < steps) x = hn::Max(lowest, hn::Min(highest, hn::Sub(x, halley)));
    }
    alignas(64) double result[3][table_lanes];
    hn::StoreU(x, Lanes(), result[0]);
    hn::StoreU(value, Lanes(), result[1]);
    hn::StoreU(missed, Lanes(), result[2]);
    for (int i = 0; i < lanes && begin + i < count; ++i) {
      FoundExtremum& e = found[static_cast<std::size_t>(begin + i)];
      e.at = result[0][i];
      e.value = result[1][i];
      e.missed = result[2][i];
    }
  }
}

/// Residues of one channel; zero columns of the rows are skipped.
HWY_INLINE void residues_of(const RootTable& table, int lane, const PolePairs& poles, const ObservedRow& row, PairPack* r) {
  for (int k = 0; k < poles.count; ++k) {
    PairPack sum = {hn::Zero(Lanes()), hn::Zero(Lanes())}, rate = sum;
    for (int j = 0; j < table.coordinates; ++j) {
      const double on_displacement = row.on_displacement(j), on_velocity = row.on_velocity.size() > 0 ? row.on_velocity(j) : 0;
      const Pack first = from_table(table.r_first[k][j], lane), second = from_table(table.r_second[k][j], lane);
      if (on_displacement != 0) sum = {hn::MulAdd(all(on_displacement), first, sum.first), hn::MulAdd(all(on_displacement), second, sum.second)};
      if (on_velocity != 0) rate = {hn::MulAdd(all(on_velocity), first, rate.first), hn::MulAdd(all(on_velocity), second, rate.second)};
    }
    r[k] = sum;
    if (row.on_velocity.size() > 0) {
      const PairPack turned = times(poles.real[k], poles.lambda[k], rate);
      r[k] = {hn::Add(sum.first, turned.first), hn::Add(sum.second, turned.second)};
    }
  }
}

/// Is the height good enough for what is asked: to 1e-10 near the top, else to a share of what a peak must rise by?
inline bool is_settled(const FoundExtremum& e, double best, const PeakQuestion& question) {
  constexpr double settled = 1e-10, near_top = 0.25, share = 0.01;
  const double low = low_share * question.min_prominence;
  if (question.count_peaks && std::abs(e.value) + e.missed < low * low * best) return true;
  if (!question.count_peaks || (e.maximum && e.value > near_top * best)) return e.missed <= settled * e.value;
  return e.missed <= share * question.min_prominence * std::sqrt(best * e.value);
}

/// Curves of as many designs as there are lanes, `lane` first.
template <typename Size>
void answer(Size n, const RootTable& table, const PeakQuestion& question, int lane, TablePeaks& peaks) {
  const auto channels = static_cast<int>(question.rows.size());
  const int lanes = lane_count();
  const WalkOptions options{question.count_peaks, question.min_prominence};
  PolePairs poles;
  WalkedPack<Size> pack;
  poles.count = n;
  pack.count = n;
  double asked[table_lanes];
  for (int i = 0; i < lanes; ++i) asked[i] = table.good[lane + i];
  pack.asked = hn::Gt(hn::LoadU(Lanes(), asked), hn::Zero(Lanes()));
  for (int k = 0; k < n; ++k) {
    poles.real[k] = pack.real[k] = hn::Ne(from_table(table.real[k], lane), hn::Zero(Lanes()));
    poles.lambda[k] = {from_table(table.first[k], lane), from_table(table.second[k], lane)};
    pack.z[k] = pole_in_square(poles.real[k], poles.lambda[k]);
  }
  PoleProducts products;
  form_products(poles, products);
  const auto curves = std::make_unique<WalkedCurve[]>(static_cast<std::size_t>(channels));
  const auto values = std::make_unique<Pack[]>(static_cast<std::size_t>(2 * channels));
  for (int c = 0; c < channels; ++c) {
    const ObservedRow& row = question.rows[static_cast<std::size_t>(c)];
    PairPack r[most_pairs];
    residues_of(table, lane, poles, row, r);
    form_squared_response(poles, products, r, row.derivative, row.on_velocity.size() == 0, curves[c].f);
    curves[c].best = curves[c].sign = hn::Zero(Lanes());
  }

  LaneMask complete = hn::Eq(hn::Zero(Lanes()), hn::Zero(Lanes()));
  pack.from = all(question.from * question.from);
  pack.to = all(question.to * question.to);
  see_values(pack, pack.from, curves.get(), channels, values.get());
  for (int k = 0; k < n; ++k)
    see_values(pack, hn::Min(hn::Max(hn::IfThenElse(pack.real[k], pack.from, pack.z[k].first), pack.from), pack.to), curves.get(), channels, nullptr);
  if (std::isfinite(question.to)) {
    see_values(pack, pack.to, curves.get(), channels, values.get() + channels);
  } else {
    pack.to = hn::Max(pack.from, beginning_of_tail(pack, curves.get(), channels, question, options, complete));
    for (int c = 0; c < channels; ++c) {
      const Pack slope = curves[c].f.slope;  // a curve that grows without end
      values[channels + c] = hn::IfThenElse(hn::Gt(slope, hn::Zero(Lanes())), all(std::numeric_limits<double>::infinity()), curves[c].f.constant);
      curves[c].best = hn::Max(curves[c].best, curves[c].f.constant);
    }
  }
  first_signs(pack, curves.get(), channels, question);

  FoundExtrema found;
  complete = hn::And(complete, walk(pack, curves.get(), channels, options, found));
  LaneStore store;
  store.pairs = n;
  store.C.resize(static_cast<std::size_t>(channels * (n + 1) * 2 * table_lanes));
  for (int k = 0; k < n; ++k) {
    hn::StoreU(pack.z[k].first, Lanes(), store.z[k][0]);
    hn::StoreU(pack.z[k].second, Lanes(), store.z[k][1]);
    hn::StoreU(hn::IfThenElseZero(pack.real[k], all(1.0)), Lanes(), store.real[k]);
  }
  for (int c = 0; c < channels; ++c) {
    for (int k = 0; k < n; ++k) {
      hn::StoreU(curves[c].f.C[k].first, Lanes(), store.of(c, k, 0));
      hn::StoreU(curves[c].f.C[k].second, Lanes(), store.of(c, k, 1));
    }
    hn::StoreU(curves[c].f.constant, Lanes(), store.of(c, n, 0));
    hn::StoreU(curves[c].f.slope, Lanes(), store.of(c, n, 1));
  }
  refine(store, found);

  double ends[2][table_lanes], ok[table_lanes];
  hn::StoreU(hn::IfThenElseZero(complete, all(1.0)), Lanes(), ok);
  for (int i = 0; i < lanes; ++i) peaks.complete[lane + i] = ok[i] != 0;
  alignas(64) double best[table_lanes];
  // The extrema of one curve, ascending, as a chain.
  std::vector<int> first(static_cast<std::size_t>(channels * lanes), -1), next(found.size(), -1);
  for (std::size_t e = found.size(); e-- > 0;) {
    int& head = first[static_cast<std::size_t>(found[e].channel * lanes + found[e].lane)];
    next[e] = head;
    head = static_cast<int>(e);
  }
  std::vector<double> heights;
  for (int c = 0; c < channels; ++c) {
    hn::StoreU(values[c], Lanes(), ends[0]);
    hn::StoreU(values[channels + c], Lanes(), ends[1]);
    hn::StoreU(curves[c].best, Lanes(), best);
    for (int i = 0; i < lanes; ++i) {
      const auto amplitude = [](double half_square) { return std::sqrt(std::max(2 * half_square, 0.0)); };
      ChannelPeaks& answer = peaks.channels[static_cast<std::size_t>(c * table_lanes + lane + i)];
      answer = {amplitude(ends[0][i]), question.from, 0, 0};
      heights.assign(1, answer.highest);
      for (int at = first[static_cast<std::size_t>(c * lanes + i)]; at >= 0; at = next[static_cast<std::size_t>(at)]) {
        const FoundExtremum& e = found[static_cast<std::size_t>(at)];
        if (!is_settled(e, best[i], question)) peaks.complete[lane + i] = false;
        const double height = amplitude(e.value);
        heights.push_back(height);
        if (e.maximum && height > answer.highest) answer.highest = height, answer.highest_at = std::sqrt(e.at);
      }
      heights.push_back(amplitude(ends[1][i]));
      if (heights.back() > answer.highest) answer.highest = heights.back(), answer.highest_at = question.to;
      if (!question.count_peaks) continue;
      const PeakCount count = prominent_peaks(heights, question.min_prominence * (std::isfinite(answer.highest) ? answer.highest : 0));
      if (count.close) peaks.complete[lane + i] = false;  // what passed as low may decide
      answer.peaks = count.peaks;
      answer.largest_rise = count.largest_rise;
    }
  }
}

void peaks_in_lanes(const RootTable& table, const PeakQuestion& question, TablePeaks& peaks) {
  peaks.channels.resize(question.rows.size() * table_lanes);
  for (int lane = 0; lane < table_lanes; lane += lane_count()) table.coordinates == 6 ? answer(six_coordinates(), table, question, lane, peaks) : answer(AtMostTwelve{table.coordinates}, table, question, lane, peaks);
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "trivet/numerics/dispatch.h"

namespace trivet::numerics {

TRIVET_VARIANTS(peaks_in_lanes);

void peaks_from_roots(const RootTable& table, const PeakQuestion& question, TablePeaks& peaks) {
  TRIVET_DISPATCH(peaks_in_lanes)(table, question, peaks);
}

}  // namespace trivet::numerics
#endif
