// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/peaks_from_roots.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "trivet/numerics/certain_top-inl.h"
#include "trivet/numerics/peak_count.h"
#include "trivet/numerics/root_table.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

HWY_INLINE Pack from_table(const double* row, int lane) { return hn::LoadU(Lanes(), row + lane); }

/// Values of all curves at x, which may be their highest.
template <typename Size>
HWY_NOINLINE void see_values(const WalkedPack<Size>& pack, const Pack& x, WalkedCurve* curves, int channels, Pack* values) {
  PairPack w[Size::most];
  each(pack.poles.count, [&](int k) TRIVET_LANES { w[k] = reach(pack.poles, k, x); });
  for (int c = 0; c < channels; ++c) {
    values[c] = hn::MulAdd(curves[c].f.slope, x, curves[c].f.constant);
    each(pack.poles.count, [&](int k) TRIVET_LANES { values[c] = sum_of(curves[c].f.C[k], w[k], values[c]); });
    curves[c].best = hn::Max(curves[c].best, values[c]);
  }
}

/// Where the last piece of the axis begins, on which every slope keeps its sign to x = ∞ or nothing matters any more. In u = 1/x a curve has the
/// same form, with poles 1/z, and one panel reaches from there to u = 0.
/// @param complete  leaves the lanes where that is proven
template <typename Size>
HWY_NOINLINE Pack beginning_of_tail(const WalkedPack<Size>& pack, WalkedCurve* curves, int channels, const PeakQuestion& question, const WalkOptions& options,
                                  LaneMask& complete) {
  constexpr int most_doublings = 40;
  const SquarePoles<Size>& poles = pack.poles;
  WalkedPack<Size> inverted = pack;
  Pack begins = hn::Add(pack.from, pack.from);
  PairPack weight[Size::most];
  for (int k = 0; k < poles.count; ++k) {
    begins = hn::Max(begins, hn::Mul(all(2.0), hn::Add(hn::Abs(poles.centre[k]), hn::Abs(poles.aside[k]))));
    inverted.poles.z[k] = inverse(poles.real[k], poles.z[k]);
    weight[k] = all(-1.0) * times(poles.real[k], inverted.poles.z[k], inverted.poles.z[k]);
  }
  place(inverted.poles);
  const std::unique_ptr<WalkedCurve[]> inverted_curves(new WalkedCurve[static_cast<std::size_t>(channels)]);
  for (int c = 0; c < channels; ++c) {
    WalkedCurve& curve = inverted_curves[static_cast<std::size_t>(c)] = curves[c];
    curve.f.slope = hn::Zero(Lanes());
    for (int k = 0; k < poles.count; ++k) {
      const LaneMask real = poles.real[k];
      const PairPack C = at_poles(real, curve.f.C[k]), part = times(real, C, inverted.poles.z[k]);
      curve.f.C[k] = for_half_sum(real, times(real, C, weight[k]));
      curve.f.constant = hn::Sub(curve.f.constant, hn::Mul(all(0.5), hn::IfThenElse(real, hn::Add(part.first, part.second), hn::Add(part.first, part.first))));
    }
  }
  LaneMask settled = hn::Not(pack.asked);
  for (int doubling = 0; doubling < most_doublings && !hn::AllTrue(Lanes(), settled); ++doubling) {
    if (doubling > 0) begins = hn::IfThenElse(settled, begins, hn::Add(begins, begins));
    PanelPowers powers[Size::most];
    const Pack half = hn::Div(all(0.5), begins);
    form_powers(inverted.poles, half, half, powers);
    LaneMask all_settled = hn::Eq(half, half);
    for (int c = 0; c < channels; ++c) {
      WalkedCurve& curve = inverted_curves[static_cast<std::size_t>(c)];
      LaneMask own = settle(inverted, powers, half, half, options, settled, curve);
      // Slopes that vanish at u = 0 keep their sign while they are monotonic.
      const ObservedRow& row = question.rows[static_cast<std::size_t>(c)];
      const bool flat_at_infinity = row.on_velocity.size() == 0 && row.derivative == 0;
      if (!flat_at_infinity) own = hn::And(own, hn::Or(hn::Eq(curve.after, hn::Zero(Lanes())), hn::Gt(hn::Mul(curve.start, curve.after), curve.rest)));
      all_settled = hn::And(all_settled, own);
      curves[c].tail = hn::IfThenElse(settled, curves[c].tail, hn::Neg(curve.after));  // x falls as u rises
    }
    settled = hn::Or(settled, all_settled);
  }
  complete = hn::And(complete, settled);
  return begins;
}

/// Signs of the slopes where the walk begins; 0 where round-off hides them.
template <typename Size>
HWY_NOINLINE void first_signs(const WalkedPack<Size>& pack, WalkedCurve* curves, int channels, const PeakQuestion& question) {
  PanelPowers powers[Size::most];
  form_powers(pack.poles, pack.from, hn::Zero(Lanes()), powers);
  const WalkOptions options{false, 0};
  for (int c = 0; c < channels; ++c) {
    settle(pack, powers, pack.from, hn::Zero(Lanes()), options, hn::Not(pack.asked), curves[c]);
    curves[c].sign = curves[c].after;
    // |y|² begins like x^derivative at rest.
    if (question.from == 0 && question.rows[static_cast<std::size_t>(c)].derivative > 0) curves[c].sign = all(1.0);
  }
}

/// What is known of all curves of all lanes, for extrema that stand in any of them.
template <typename Size>
class LaneStore {
 public:
  LaneStore(const SquarePoles<Size>& poles, const WalkedCurve* curves, int channels)
      : count_(poles.count), of_channel_(static_cast<std::size_t>((poles.count + 1) * 2)), C_(static_cast<std::size_t>(channels) * of_channel_ * table_lanes) {
    for (int k = 0; k < count_; ++k) {
      hn::StoreU(poles.z[k].first, Lanes(), z_[k][0]);
      hn::StoreU(poles.z[k].second, Lanes(), z_[k][1]);
      hn::StoreU(hn::IfThenElseZero(poles.real[k], all(1.0)), Lanes(), real_[k]);
    }
    for (int c = 0; c < channels; ++c) {
      double* to = C_.data() + static_cast<std::size_t>(c) * of_channel_ * table_lanes;
      const auto keep = [&](const Pack& numbers) HWY_ATTR {
        hn::StoreU(numbers, Lanes(), to);
        to += table_lanes;
      };
      for (int k = 0; k < count_; ++k) {
        keep(curves[c].f.C[k].first);
        keep(curves[c].f.C[k].second);
      }
      keep(curves[c].f.constant);
      keep(curves[c].f.slope);
    }
  }

  /// The curve of each extremum in a lane of its own; the last again where they end.
  void gather(const FoundExtremum* found, int count, SquarePoles<Size>& poles, SquaredResponse& f) const {
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
    const auto number = [&](std::size_t row) HWY_ATTR { return hn::GatherIndex(Lanes(), C_.data() + row * table_lanes, of_curve); };
    for (std::size_t k = 0; k < static_cast<std::size_t>(count_); ++k) f.C[k] = {number(2 * k), number(2 * k + 1)};
    f.constant = number(of_channel_ - 2);
    f.slope = number(of_channel_ - 1);
  }

 private:
  Size count_;
  std::size_t of_channel_;
  alignas(64) double z_[Size::most][2][table_lanes], real_[Size::most][table_lanes];
  std::vector<double> C_;  ///< [channel][pair, constant and slope][2][lane]
};

/// Halley's steps on f' = 0 within the panels, as many extrema at once as there are lanes.
template <typename Size>
HWY_NOINLINE void refine(const LaneStore<Size>& store, FoundExtrema& found) {
  constexpr int steps_at_most = 4;
  constexpr double settled = 1e-13;
  SquarePoles<Size> poles;
  SquaredResponse f;
  const auto count = static_cast<int>(found.size());
  for (int begin = 0; begin < count; begin += lane_count()) {
    FoundExtremum* e = found.data() + begin;
    const int taken = std::min(lane_count(), count - begin);
    store.gather(e, taken, poles, f);
    alignas(64) double numbers[3][table_lanes];
    for (int i = 0; i < lane_count(); ++i) {
      const FoundExtremum& own = e[std::min(i, taken - 1)];
      numbers[0][i] = own.at, numbers[1][i] = own.lower, numbers[2][i] = own.upper;
    }
    Pack x = from_table(numbers[0], 0), missed;
    const Pack lower = from_table(numbers[1], 0), upper = from_table(numbers[2], 0);
    Slopes s = slopes_at(poles, f, x);
    for (int i = 0; i <= steps_at_most; ++i) {
      const Pack step = step_to_extremum(s);
      missed = hn::Abs(hn::Mul(s.first, step));
      if (i == steps_at_most || hn::AllTrue(Lanes(), hn::Le(missed, hn::Mul(all(settled), s.value)))) break;
      x = hn::Max(lower, hn::Min(upper, hn::Add(x, step)));
      s = slopes_at(poles, f, x);
    }
    hn::StoreU(x, Lanes(), numbers[0]);
    hn::StoreU(s.value, Lanes(), numbers[1]);
    hn::StoreU(missed, Lanes(), numbers[2]);
    for (int i = 0; i < taken; ++i) e[i].at = numbers[0][i], e[i].value = numbers[1][i], e[i].missed = numbers[2][i];
  }
}

/// Residues of one channel; zero columns of the rows are skipped.
HWY_NOINLINE void residues_of(const RootTable& table, int lane, const PolePairs& poles, const ObservedRow& row, PairPack* r) {
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

/// How far a height may be off, as a share of what a peak must rise by: nothing to speak of near the top (1e-10) and where no peaks are counted; ∞ where
/// the steps towards it did not settle.
inline double doubt(const FoundExtremum& e, double best, const PeakQuestion& question) {
  constexpr double settled = 1e-10, near_top = 0.25, none = 0, all = std::numeric_limits<double>::infinity();
  const double least = question.min_prominence * std::sqrt(best), highest = std::sqrt(std::abs(e.value) + e.missed);
  // Where the walk passed by as too low, an extremum stands next to it, or the curve goes on as before.
  if (e.missed <= settled * e.value) return highest > 2 * low_share * least ? none : low_share;
  if (!question.count_peaks || (e.maximum && e.value > near_top * best)) return all;
  if (highest < most_doubt * least) return highest / least;
  const double off = e.missed / (least * std::sqrt(std::abs(e.value)));
  return off < low_share ? off : all;
}

/// Curves of as many designs as there are lanes.
template <typename Size>
class PackOfCurves {
 public:
  PackOfCurves(Size n, const RootTable& table, const PeakQuestion& question, int lane)
      : question_(question), lane_(lane), channels_(static_cast<int>(question.rows.size())), curves_(new WalkedCurve[question.rows.size()]),
        values_(new Pack[(3 + static_cast<std::size_t>(n)) * question.rows.size()]), tops_(new Top[question.count_peaks ? 0 : question.rows.size()]) {
    form(n, table);
  }

  void search() {
    const SquarePoles<Size>& poles = pack_.poles;
    see_values(pack_, pack_.from, curves_.get(), channels_, at_start());
    for (int k = 0; k < poles.count; ++k) {
      const Pack above = hn::IfThenElse(poles.real[k], pack_.from, hn::Max(pack_.from, hn::Min(pack_.to, poles.centre[k])));
      see_values(pack_, above, curves_.get(), channels_, at_poles() + k * channels_);
    }
    see_end();
    if (!question_.count_peaks) find_tops();
    else first_signs(pack_, curves_.get(), channels_, question_);
    complete_ = hn::And(complete_, walk(pack_, curves_.get(), channels_, options(), found_));
    // A slope that turned where the walk could not tell its sign, and that keeps the new one to x = ∞.
    for (int c = 0; c < channels_; ++c) complete_ = hn::And(complete_, hn::Ge(hn::Mul(curves_[c].sign, curves_[c].tail), hn::Zero(Lanes())));
    refine(LaneStore<Size>(poles, curves_.get(), channels_), found_);
  }

  void tell(TablePeaks& peaks) const {
    const int lanes = lane_count();
    alignas(64) double complete[table_lanes], numbers[6][table_lanes];
    hn::StoreU(hn::IfThenElseZero(complete_, all(1.0)), Lanes(), complete);
    for (int i = 0; i < lanes; ++i) peaks.complete[lane_ + i] = complete[i] != 0;
    // The extrema of one curve, ascending, as a chain.
    std::vector<int> first(static_cast<std::size_t>(channels_ * lanes), -1), next(found_.size(), -1);
    for (std::size_t e = found_.size(); e-- > 0;) {
      int& head = first[static_cast<std::size_t>(found_[e].channel * lanes + found_[e].lane)];
      next[e] = head;
      head = static_cast<int>(e);
    }
    std::vector<double> heights;
    for (int c = 0; c < channels_; ++c) {
      hn::StoreU(at_start()[c], Lanes(), numbers[0]);
      hn::StoreU(at_end()[c], Lanes(), numbers[1]);
      hn::StoreU(curves_[c].best, Lanes(), numbers[2]);
      if (!question_.count_peaks) {
        hn::StoreU(hn::IfThenElseZero(tops_[c].settled, tops_[c].value), Lanes(), numbers[3]);
        hn::StoreU(tops_[c].at, Lanes(), numbers[4]);
      }
      for (int i = 0; i < lanes; ++i) {
        ChannelPeaks& answer = peaks.channels[static_cast<std::size_t>(c * table_lanes + lane_ + i)];
        answer = {amplitude(numbers[0][i]), question_.from, 0, 0};
        const auto see = [&](double height, double at) {
          if (height > answer.highest) answer.highest = height, answer.highest_at = at;
        };
        if (!question_.count_peaks) see(amplitude(numbers[3][i]), std::sqrt(numbers[4][i]));
        double doubtful = 1e-6;  // round-off
        heights.assign(1, answer.highest);
        for (int at = first[static_cast<std::size_t>(c * lanes + i)]; at >= 0; at = next[static_cast<std::size_t>(at)]) {
          const FoundExtremum& e = found_[static_cast<std::size_t>(at)];
          doubtful = std::max(doubtful, doubt(e, numbers[2][i], question_));
          heights.push_back(amplitude(e.value));
          if (e.maximum) see(heights.back(), std::sqrt(e.at));
        }
        heights.push_back(amplitude(numbers[1][i]));
        see(heights.back(), question_.to);
        if (std::isinf(doubtful)) peaks.complete[lane_ + i] = false;
        if (!question_.count_peaks) continue;
        const PeakCount count = prominent_peaks(heights, question_.min_prominence * answer.highest);
        if (count.closest < 2 * doubtful) peaks.complete[lane_ + i] = false;  // what is in doubt may decide
        answer.peaks = count.peaks;
        answer.largest_rise = count.largest_rise;
      }
    }
  }

 private:
  [[nodiscard]] WalkOptions options() const { return {question_.count_peaks, question_.min_prominence}; }
  [[nodiscard]] Pack* at_start() const { return values_.get(); }
  [[nodiscard]] Pack* at_end() const { return values_.get() + channels_; }
  [[nodiscard]] Pack* at_poles() const { return values_.get() + 2 * channels_; }  ///< [pole][channel]
  static double amplitude(double half_square) { return std::sqrt(std::max(2 * half_square, 0.0)); }

  void form(Size n, const RootTable& table) {
    double asked[table_lanes];
    for (int i = 0; i < lane_count(); ++i) asked[i] = table.good[lane_ + i];
    pack_.asked = hn::Gt(hn::LoadU(Lanes(), asked), hn::Zero(Lanes()));
    PolePairs roots;
    roots.count = pack_.poles.count = n;
    for (int k = 0; k < n; ++k) {
      roots.real[k] = pack_.poles.real[k] = hn::Ne(from_table(table.real[k], lane_), hn::Zero(Lanes()));
      roots.lambda[k] = {from_table(table.first[k], lane_), from_table(table.second[k], lane_)};
      pack_.poles.z[k] = pole_in_square(roots.real[k], roots.lambda[k]);
    }
    place(pack_.poles);
    pack_.from = all(question_.from * question_.from);
    pack_.to = all(question_.to * question_.to);
    PoleProducts products;
    form_products(roots, products);
    for (int c = 0; c < channels_; ++c) {
      const ObservedRow& row = question_.rows[static_cast<std::size_t>(c)];
      PairPack r[most_pairs];
      residues_of(table, lane_, roots, row, r);
      WalkedCurve& curve = curves_[c];
      form_squared_response(roots, products, r, row.derivative, row.on_velocity.size() == 0, curve.f);
      curve.best = curve.sign = curve.tail = hn::Zero(Lanes());
      curve.covered_from = all(1.0);
      curve.covered_to = all(-1.0);
    }
    complete_ = hn::Eq(pack_.from, pack_.from);
  }

  void see_end() {
    if (std::isfinite(question_.to)) {
      see_values(pack_, pack_.to, curves_.get(), channels_, at_end());
      return;
    }
    pack_.to = hn::Max(pack_.from, beginning_of_tail(pack_, curves_.get(), channels_, question_, options(), complete_));
    for (int c = 0; c < channels_; ++c) {
      const Pack slope = curves_[c].f.slope;  // a curve that grows without end
      const LaneMask grows = hn::Gt(slope, hn::Zero(Lanes()));
      at_end()[c] = hn::IfThenElse(grows, all(std::numeric_limits<double>::infinity()), curves_[c].f.constant);
      if (question_.count_peaks) complete_ = hn::AndNot(grows, complete_);  // the tail is proven without that growth
      curves_[c].best = hn::Max(curves_[c].best, curves_[c].f.constant);
    }
  }

  void find_tops() {
    for (int c = 0; c < channels_; ++c) {
      Pack above[Size::most];
      for (int k = 0; k < pack_.poles.count; ++k) above[k] = hn::IfThenZeroElse(pack_.poles.real[k], at_poles()[k * channels_ + c]);
      tops_[c] = find_top(pack_, above, curves_[c]);
    }
    form_zones(pack_.poles, pack_.from, pack_.to, pack_.zones);
    open_zones(pack_, tops_.get(), curves_.get(), channels_);
  }

  const PeakQuestion& question_;
  int lane_, channels_;
  WalkedPack<Size> pack_;
  std::unique_ptr<WalkedCurve[]> curves_;
  std::unique_ptr<Pack[]> values_;  ///< of all curves at the start, at the end, and above each pole
  std::unique_ptr<Top[]> tops_;
  LaneMask complete_;
  FoundExtrema found_;
};

template <typename Size>
void answer(Size n, const RootTable& table, const PeakQuestion& question, int lane, TablePeaks& peaks) {
  PackOfCurves<Size> curves(n, table, question, lane);
  curves.search();
  curves.tell(peaks);
}

void peaks_in_lanes(const RootTable& table, const PeakQuestion& question, TablePeaks& peaks) {
  peaks.channels.resize(question.rows.size() * table_lanes);
  for (int lane = 0; lane < table_lanes; lane += lane_count())
    table.coordinates == 6 ? answer(six_coordinates(), table, question, lane, peaks) : answer(AtMostTwelve{table.coordinates}, table, question, lane, peaks);
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
