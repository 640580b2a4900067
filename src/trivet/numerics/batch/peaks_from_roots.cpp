// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/batch/peaks_from_roots.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "trivet/foundation/index.h"
#include "trivet/numerics/batch/axis_tail-inl.h"
#include "trivet/numerics/batch/curve_residues-inl.h"
#include "trivet/numerics/batch/highest_maximum-inl.h"
#include "trivet/numerics/batch/peak_question.h"
#include "trivet/numerics/batch/refined_extrema-inl.h"
#include "trivet/numerics/peaks/peak_count.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

/// Values of all curves at x; updates their best values.
template <typename Size>
HWY_NOINLINE void update_maxima(const ScannedPack<Size>& pack, const Pack& x, ScannedCurve* curves, int channels,
                                Pack* values) {
  PairPack w[Size::most];
  each(pack.poles.count, [&](int k) TRIVET_LANES { w[k] = inverse_distance(pack.poles, k, x); });
  for (int c = 0; c < channels; ++c) {
    values[c] = hn::MulAdd(curves[c].f.slope, x, curves[c].f.constant);
    each(pack.poles.count, [&](int k) TRIVET_LANES { values[c] = sum_of(curves[c].f.C[k], w[k], values[c]); });
    curves[c].best = hn::Max(curves[c].best, values[c]);
  }
}

/// Signs of the slopes at the start of the scan; 0 if round-off hides them.
template <typename Size>
HWY_NOINLINE void first_signs(const ScannedPack<Size>& pack, ScannedCurve* curves, int channels,
                              const PeakQuestion& question) {
  PanelPowers powers[Size::most];
  form_powers(pack.poles, pack.from, hn::Zero(Lanes()), powers);
  const ScanOptions options{false, 0};
  for (int c = 0; c < channels; ++c) {
    bound_slope(pack, powers, pack.from, hn::Zero(Lanes()), options, hn::Not(pack.asked), curves[c]);
    curves[c].sign = curves[c].after;
    // |y|² starts like x^derivative at rest.
    if (question.from == 0 && question.rows[to_size(c)].derivative > 0) curves[c].sign = all(1.0);
  }
}

constexpr double accuracy_of_rise = 1e-6;  // relative; margins are kept in single precision

/// Possible error of a height, as a share of the required rise of a peak. Near the top, and if no peaks are counted,
/// the refinement must converge to 1e-10; ∞ if it did not converge.
inline double doubt(const FoundExtremum& e, double best, const PeakQuestion& question) {
  constexpr double settled = 1e-10, near_top = 0.25, none = 0, all = std::numeric_limits<double>::infinity();
  const double least = question.min_prominence * std::sqrt(best), highest = std::sqrt(std::abs(e.value) + e.missed);
  // If the scan skipped a panel as too low, an extremum is next to it, or the curve continues as before.
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
      : question_(question),
        lane_(lane),
        channels_(static_cast<int>(question.rows.size())),
        curves_(new ScannedCurve[question.rows.size()]),
        values_(new Pack[(3 + to_size(n)) * question.rows.size()]),
        tops_(new Top[question.count_peaks ? 0 : question.rows.size()]) {
    form(n, table);
  }

  void search() {
    const SquarePoles<Size>& poles = pack_.poles;
    update_maxima(pack_, pack_.from, curves_.get(), channels_, at_start());
    for (int c = 0; c < channels_ && question_.from == 0; ++c)
      if (question_.rows[to_size(c)].derivative > 0) at_start()[c] = hn::Zero(Lanes());  // exactly
    for (int k = 0; k < poles.count; ++k) {
      const Pack above =
          hn::IfThenElse(poles.real[k], pack_.from, hn::Max(pack_.from, hn::Min(pack_.to, poles.centre[k])));
      update_maxima(pack_, above, curves_.get(), channels_, at_poles() + k * channels_);
    }
    evaluate_end();
    if (!question_.count_peaks) find_tops();
    else first_signs(pack_, curves_.get(), channels_, question_);
    complete_ = hn::And(complete_, scan(pack_, curves_.get(), channels_, options(), found_));
    // Rejects a slope that changed sign unseen by the scan and that keeps the new sign up to x = ∞.
    for (int c = 0; c < channels_; ++c)
      complete_ = hn::And(complete_, hn::Ge(hn::Mul(curves_[c].sign, curves_[c].tail), hn::Zero(Lanes())));
    refine(LaneStore<Size>(poles, curves_.get(), channels_, question_.rows, round_off_), found_);
  }

  void write_answers(TablePeaks& peaks) const {
    const int lanes = lane_count();
    alignas(64) double numbers[5][table_lanes], highest[table_lanes], highest_at[table_lanes],
        start_doubts[table_lanes] = {}, end_doubts[table_lanes] = {};
    bool known[table_lanes];
    store_mask(complete_, peaks.complete + lane_);
    // The extrema of one curve, ascending, as a linked list.
    std::vector<int> first(to_size(channels_ * lanes), -1), next(found_.size(), -1);
    for (std::size_t e = found_.size(); e-- > 0;) {
      int& head = first[to_size(found_[e].channel * lanes + found_[e].lane)];
      next[e] = head;
      head = static_cast<int>(e);
    }
    std::vector<double> heights, doubts;
    for (int c = 0; c < channels_; ++c) {
      hn::StoreU(at_start()[c], Lanes(), numbers[0]);
      hn::StoreU(at_end()[c], Lanes(), numbers[1]);
      hn::StoreU(curves_[c].best, Lanes(), numbers[2]);
      if (!question_.count_peaks) {
        hn::StoreU(hn::IfThenElseZero(tops_[c].settled, tops_[c].value), Lanes(), numbers[3]);
        hn::StoreU(tops_[c].at, Lanes(), numbers[4]);
      }
      if (question_.count_peaks) {
        hn::StoreU(doubt_at(c, pack_.from, question_.from, at_start()[c]), Lanes(), start_doubts);
        hn::StoreU(doubt_at(c, pack_.to, question_.to, at_end()[c]), Lanes(), end_doubts);
      }
      for (int i = 0; i < lanes; ++i) {
        ChannelPeaks& answer = peaks.channels[to_size(c * table_lanes + lane_ + i)];
        answer = {amplitude(numbers[0][i]), question_.from, 0, 0};
        const auto raise = [&](double height, double at) {
          if (height > answer.highest) answer.highest = height, answer.highest_at = at;
        };
        if (!question_.count_peaks) raise(amplitude(numbers[3][i]), std::sqrt(numbers[4][i]));
        double doubtful = 1e-6;  // round-off
        heights.assign(1, answer.highest);
        doubts.assign(1, start_doubts[i]);
        for (int at = first[to_size(c * lanes + i)]; at >= 0; at = next[to_size(at)]) {
          const FoundExtremum& e = found_[to_size(at)];
          doubtful = std::max(doubtful, doubt(e, numbers[2][i], question_));
          heights.push_back(amplitude(e.value));
          // A panel skipped as too low may be even lower than such a minimum.
          const bool hidden =
              std::sqrt(std::abs(e.value)) <= 2 * low_share * question_.min_prominence * std::sqrt(numbers[2][i]);
          doubts.push_back(std::max(share(e.missed, e.value), hidden ? 1.0 : 0.0));
          if (e.maximum) raise(heights.back(), std::sqrt(e.at));
        }
        heights.push_back(amplitude(numbers[1][i]));
        doubts.push_back(end_doubts[i]);
        raise(heights.back(), question_.to);
        highest[i] = answer.highest, highest_at[i] = answer.highest_at;
        // No value found during the search may be higher.
        if (std::isinf(doubtful) || answer.highest < amplitude(numbers[2][i]) * (1 - 1e-9))
          peaks.complete[lane_ + i] = false;
        if (!question_.count_peaks) continue;
        const double least = question_.min_prominence * answer.highest;
        const PeakCount count = prominent_peaks(heights, least);
        if (count.closest < 2 * doubtful)
          peaks.complete[lane_ + i] = false;  // the doubtful part could change the count
        if (!rise_is_known(heights, doubts, least, count.largest_rise, accuracy_of_rise))
          peaks.complete[lane_ + i] = false;
        answer.peaks = count.peaks;
        answer.largest_rise = count.largest_rise;
      }
      store_mask(has_digits_at(c, hn::LoadU(Lanes(), highest), hn::LoadU(Lanes(), highest_at)), known);
      for (int i = 0; i < lanes; ++i) peaks.complete[lane_ + i] = peaks.complete[lane_ + i] && known[i];
    }
  }

 private:
  [[nodiscard]] ScanOptions options() const { return {question_.count_peaks, question_.min_prominence}; }
  [[nodiscard]] Pack* at_start() const { return values_.get(); }
  [[nodiscard]] Pack* at_end() const { return values_.get() + channels_; }
  [[nodiscard]] Pack* at_poles() const { return values_.get() + 2 * channels_; }  ///< [pole][channel]
  static double share(double missed, double value) { return missed <= 0 ? 0 : 0.5 * missed / std::abs(value); }
  /// Relative error of a height at an end of the band by round-off.
  [[nodiscard]] Pack doubt_at(int channel, const Pack& x, double omega, const Pack& value) const {
    const SquaredResponse& f = curves_[channel].f;
    if (omega == 0 && question_.rows[to_size(channel)].derivative > 0) return hn::Zero(Lanes());  // zero at rest
    const Pack missed =
        hn::Mul(hn::Mul(all(0.5), round_off_), std::isinf(omega) ? f.constant_parts : sum_of_moduli(pack_.poles, f, x));
    return hn::IfThenElseZero(hn::Gt(missed, hn::Zero(Lanes())), hn::Div(missed, hn::Abs(value)));
  }
  static double amplitude(double half_square) { return std::sqrt(std::max(2 * half_square, 0.0)); }

  /// Whether a height is known to nine digits.
  [[nodiscard]] LaneMask has_digits_at(int channel, const Pack& height, const Pack& omega) const {
    const SquaredResponse& f = curves_[channel].f;
    const Pack infinity = all(std::numeric_limits<double>::infinity()),
               value = hn::Mul(all(0.5), hn::Mul(height, height));
    const LaneMask endless = hn::Eq(omega, infinity);
    const Pack moduli = sum_of_moduli(pack_.poles, f, hn::IfThenElse(endless, pack_.from, hn::Mul(omega, omega)));
    return has_digits(hn::IfThenElse(endless, f.constant_parts, moduli), round_off_, value);
  }

  void form(Size n, const RootTable& table) {
    double asked[table_lanes];
    for (int i = 0; i < lane_count(); ++i) asked[i] = table.good[lane_ + i];
    pack_.asked = hn::Gt(hn::LoadU(Lanes(), asked), hn::Zero(Lanes()));
    PolePairs roots;
    roots_in_table(n, table, lane_, roots, pack_.poles);
    round_off_ = from_table(table.round_off, lane_);
    pack_.from = all(question_.from * question_.from);
    pack_.to = all(question_.to * question_.to);
    PackOfResidues residues;
    residues_in_table(n, table, lane_, roots, residues);
    PoleProducts products;
    form_products(roots, products);
    complete_ = hn::Eq(pack_.from, pack_.from);
    for (int c = 0; c < channels_; ++c) {
      const ObservedRow& row = question_.rows[to_size(c)];
      PairPack r[most_pairs];
      complete_ = hn::And(complete_, residues_of(n, residues, roots, row, r));
      ScannedCurve& curve = curves_[c];
      form_squared_response(roots, products, r, row.derivative, row.on_velocity.size() == 0, curve.f);
      curve.best = curve.sign = curve.tail = hn::Zero(Lanes());
      curve.covered_from = all(1.0);
      curve.covered_to = all(-1.0);
    }
  }

  void evaluate_end() {
    if (std::isfinite(question_.to)) {
      update_maxima(pack_, pack_.to, curves_.get(), channels_, at_end());
      return;
    }
    pack_.to = hn::Max(pack_.from, beginning_of_tail(pack_, curves_.get(), channels_, question_, options(), complete_));
    for (int c = 0; c < channels_; ++c) {
      const Pack slope = curves_[c].f.slope;  // positive if the curve grows without bound
      const LaneMask grows = hn::Gt(slope, hn::Zero(Lanes()));
      at_end()[c] = hn::IfThenElse(grows, all(std::numeric_limits<double>::infinity()), curves_[c].f.constant);
      if (question_.count_peaks) complete_ = hn::AndNot(grows, complete_);  // the tail is proven without that growth
      // The growth is unknown if that sum is round-off, including that of the residues (condition numbers up to 1e3).
      const LaneMask cancelled =
          hn::Lt(hn::Abs(slope), hn::Mul(hn::Mul(all(1e3), round_off_), curves_[c].f.slope_parts));
      complete_ = hn::AndNot(cancelled, complete_);
      curves_[c].best = hn::Max(curves_[c].best, curves_[c].f.constant);
    }
  }

  void find_tops() {
    for (int c = 0; c < channels_; ++c) {
      Pack above[Size::most];
      for (int k = 0; k < pack_.poles.count; ++k)
        above[k] = hn::IfThenZeroElse(pack_.poles.real[k], at_poles()[k * channels_ + c]);
      tops_[c] = find_top(pack_, above, curves_[c]);
    }
    form_zones(pack_.poles, pack_.from, pack_.to, pack_.zones);
    open_zones(pack_, tops_.get(), curves_.get(), channels_);
  }

  const PeakQuestion& question_;
  int lane_, channels_;
  ScannedPack<Size> pack_;
  std::unique_ptr<ScannedCurve[]> curves_;
  std::unique_ptr<Pack[]> values_;  ///< of all curves at the start, at the end, and at each pole
  std::unique_ptr<Top[]> tops_;
  Pack round_off_;  ///< of sums over the roots, relative to their terms
  LaneMask complete_;
  FoundExtrema found_;
};

template <typename Size>
void answer(Size n, const RootTable& table, const PeakQuestion& question, int lane, TablePeaks& peaks) {
  PackOfCurves<Size> curves(n, table, question, lane);
  curves.search();
  curves.write_answers(peaks);
}

void peaks_in_lanes(const RootTable& table, const PeakQuestion& question, TablePeaks& peaks) {
  peaks.channels.resize(question.rows.size() * table_lanes);
  for (int lane = 0; lane < table_lanes; lane += lane_count())
    table.coordinates == 6 ? answer(six_coordinates(), table, question, lane, peaks)
                           : answer(AtMostTwelve{table.coordinates}, table, question, lane, peaks);
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "trivet/numerics/lanes/dispatch.h"

namespace trivet::numerics {

TRIVET_VARIANTS(peaks_in_lanes);

void peaks_from_roots(const RootTable& table, const PeakQuestion& question, TablePeaks& peaks) {
  TRIVET_DISPATCH(peaks_in_lanes)(table, question, peaks);
}

}  // namespace trivet::numerics
#endif
