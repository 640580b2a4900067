// SPDX-License-Identifier: BSD-3-Clause
// Highest values and peaks of several |y|², one design per lane, given as partial fractions in x: x = ω² if roots and
// residues come in conjugate pairs, x = ω otherwise.
#if defined(TRIVET_NUMERICS_CURVE_SEARCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_CURVE_SEARCH_INL_H_
#undef TRIVET_NUMERICS_CURVE_SEARCH_INL_H_
#else
#define TRIVET_NUMERICS_CURVE_SEARCH_INL_H_
#endif

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "trivet/foundation/index.h"
#include "trivet/numerics/batch/axis_tail-inl.h"
#include "trivet/numerics/batch/highest_maximum-inl.h"
#include "trivet/numerics/batch/peak_request.h"
#include "trivet/numerics/batch/refined_extrema-inl.h"
#include "trivet/numerics/batch/round_off-inl.h"
#include "trivet/numerics/peaks/peak_count.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

/// Curves to search: poles in x, one |y|² per channel. A search fills the rest.
template <typename Size>
struct FormedCurves {
  explicit FormedCurves(std::vector<CurveEnds> of) : ends(std::move(of)), curves(new ScannedCurve<Size>[ends.size()]) {}
  std::vector<CurveEnds> ends;                   ///< one per channel
  ScannedPack<Size> pack;                        ///< poles, wanted lanes
  std::unique_ptr<ScannedCurve<Size>[]> curves;  ///< their f
  Pack round_off;                                ///< of sums over the poles, relative to the sums of their moduli
  LaneMask complete;                             ///< lanes with accurate residues
};

/// Values of all curves at x; updates their best values.
template <typename Size>
HWY_NOINLINE void update_maxima(const ScannedPack<Size>& pack, const Pack& x, ScannedCurve<Size>* curves, int channels,
                                Pack* values) {
  PairPack w[Size::most];
  each(pack.poles.count, [&](int k) TRIVET_LANES { w[k] = inverse_distance(pack.poles, k, x); });
  for (int c = 0; c < channels; ++c) {
    values[c] = hn::MulAdd(curves[c].f.slope, x, curves[c].f.constant);
    if (curves[c].f.grows) values[c] = hn::Add(values[c], growth_at(curves[c].f.growth, x));
    each(pack.poles.count, [&](int k) TRIVET_LANES { values[c] = sum_of(curves[c].f.C[k], w[k], values[c]); });
    curves[c].best = hn::Max(curves[c].best, values[c]);
  }
}

/// Signs of the slopes at the start of the scan; 0 if round-off hides them.
template <typename Size>
HWY_NOINLINE void first_signs(const ScannedPack<Size>& pack, ScannedCurve<Size>* curves, int channels,
                              const std::vector<CurveEnds>& ends) {
  PanelPowers powers[Size::most];
  form_powers(pack.poles, pack.from, hn::Zero(Lanes()), powers);
  const ScanOptions options{false, 0};
  for (int c = 0; c < channels; ++c) {
    bound_slope(pack, powers, pack.from, hn::Zero(Lanes()), options, hn::Not(pack.wanted), curves[c]);
    curves[c].sign = curves[c].after;
    if (ends[c].zero_at_start) curves[c].sign = all(1.0);
  }
}

constexpr double accuracy_of_rise = 1e-6;  // relative; margins are kept in single precision

/// Possible error of a height, as a share of the required rise of a peak. Near the top, and if no peaks are counted,
/// the refinement must converge to 1e-10; ∞ if it did not converge.
inline double doubt(const FoundExtremum& e, double best, const SearchedBand& band) {
  constexpr double settled = 1e-10, near_top = 0.25, none = 0, all = std::numeric_limits<double>::infinity();
  const double least = band.min_prominence * std::sqrt(best), highest = std::sqrt(std::abs(e.value) + e.missed);
  // If the scan skipped a panel as too low, an extremum is next to it, or the curve continues as before.
  if (e.missed <= settled * e.value) return highest > 2 * low_share * least ? none : low_share;
  if (!band.count_peaks || (e.maximum && e.value > near_top * best)) return all;
  if (highest < most_doubt * least) return highest / least;
  const double off = e.missed / (least * std::sqrt(std::abs(e.value)));
  return off < low_share ? off : all;
}

/// Searches the curves of as many designs as there are lanes.
template <typename Size>
class CurveSearch {
 public:
  CurveSearch(FormedCurves<Size>& formed, const SearchedBand& band, int lane)
      : band_(band),
        lane_(lane),
        channels_(static_cast<int>(formed.ends.size())),
        ends_(formed.ends),
        pack_(formed.pack),
        curves_(formed.curves.get()),
        values_(new Pack[(3 + to_size(formed.pack.poles.count)) * formed.ends.size()]),
        tops_(new Top[band.count_peaks ? 0 : formed.ends.size()]),
        round_off_(formed.round_off),
        complete_(formed.complete) {
    pack_.from = all(band_.x(band_.from));
    assert(band.from >= 0 && band.to > band.from && std::isfinite(band.from) && "the band has a beginning");
    assert(lane % lane_count() == 0 && lane + lane_count() <= table_lanes && "packs divide the table");
    pack_.to = all(band_.x(band_.to));
    for (int c = 0; c < channels_; ++c) {
      ScannedCurve<Size>& curve = curves_[c];
      curve.best = curve.sign = curve.tail = hn::Zero(Lanes());
      curve.covered_from = all(1.0);
      curve.covered_to = all(-1.0);
    }
  }

  void search() {
    const SquarePoles<Size>& poles = pack_.poles;
    update_maxima(pack_, pack_.from, curves_, channels_, at_start());
    for (int c = 0; c < channels_; ++c)
      if (ends_[c].zero_at_start) at_start()[c] = hn::Zero(Lanes());  // exactly
    for (int k = 0; k < poles.count; ++k) {
      const Pack above =
          hn::IfThenElse(poles.real[k], pack_.from, hn::Max(pack_.from, hn::Min(pack_.to, poles.centre[k])));
      update_maxima(pack_, above, curves_, channels_, at_pole(k));
    }
    complete_ = hn::And(complete_, known_at_poles());
    evaluate_end();
    if (!band_.count_peaks) find_tops();
    else first_signs(pack_, curves_, channels_, ends_);
    complete_ = hn::And(complete_, scan(pack_, curves_, channels_, options(), found_));
    // Rejects a slope that changed sign unseen by the scan and that keeps the new sign up to x = ∞.
    for (int c = 0; c < channels_; ++c)
      complete_ = hn::And(complete_, hn::Ge(hn::Mul(curves_[c].sign, curves_[c].tail), hn::Zero(Lanes())));
    refine(LaneStore<Size>(poles, curves_, ends_, round_off_), found_);
  }

  void write_peaks(TablePeaks& peaks) const {
    assert(peaks.channels.size() == to_size(channels_ * table_lanes));
    const int lanes = lane_count();
    alignas(64) double numbers[5][table_lanes], highest[table_lanes], highest_at[table_lanes],
        start_doubts[table_lanes] = {}, end_doubts[table_lanes] = {};
    bool known[table_lanes], some[table_lanes];
    store_mask(complete_, peaks.complete + lane_);
    // The extrema of one curve, ascending, as a linked list.
    std::vector<int> first(to_size(channels_ * lanes), -1), next(found_.size(), -1);
    for (std::size_t e = found_.size(); e-- > 0;) {
      int& head = first[found_[e].channel * lanes + found_[e].lane];
      assert((head < 0 || found_[e].lower <= found_[head].lower) && "the scan goes along the axis");
      next[e] = head;
      head = static_cast<int>(e);
    }
    std::vector<double> heights, doubts;
    for (int c = 0; c < channels_; ++c) {
      hn::StoreU(at_start()[c], Lanes(), numbers[0]);
      hn::StoreU(at_end()[c], Lanes(), numbers[1]);
      hn::StoreU(curves_[c].best, Lanes(), numbers[2]);
      if (!band_.count_peaks) {
        hn::StoreU(hn::IfThenElseZero(tops_[c].settled, tops_[c].value), Lanes(), numbers[3]);
        hn::StoreU(tops_[c].at, Lanes(), numbers[4]);
      }
      if (band_.count_peaks) {
        hn::StoreU(doubt_at(c, pack_.from, band_.from, at_start()[c]), Lanes(), start_doubts);
        hn::StoreU(doubt_at(c, pack_.to, band_.to, at_end()[c]), Lanes(), end_doubts);
      }
      for (int i = 0; i < lanes; ++i) {
        ChannelPeaks& result = peaks.channels[c * table_lanes + lane_ + i];
        result = {amplitude(numbers[0][i]), band_.from, 0, 0};
        const auto raise = [&](double height, double at) {
          if (height > result.highest) result.highest = height, result.highest_at = at;
        };
        if (!band_.count_peaks) raise(amplitude(numbers[3][i]), band_.omega(numbers[4][i]));
        double doubtful = 1e-6;  // round-off
        heights.assign(1, result.highest);
        doubts.assign(1, start_doubts[i]);
        for (int at = first[c * lanes + i]; at >= 0; at = next[at]) {
          const FoundExtremum& e = found_[at];
          doubtful = std::max(doubtful, doubt(e, numbers[2][i], band_));
          heights.push_back(amplitude(e.value));
          // A panel skipped as too low may be even lower than such a minimum.
          const bool hidden =
              std::sqrt(std::abs(e.value)) <= 2 * low_share * band_.min_prominence * std::sqrt(numbers[2][i]);
          doubts.push_back(std::max(share(e.missed, e.value), hidden ? 1.0 : 0.0));
          if (e.maximum) raise(heights.back(), band_.omega(e.at));
        }
        heights.push_back(amplitude(numbers[1][i]));
        doubts.push_back(end_doubts[i]);
        raise(heights.back(), band_.to);
        highest[i] = result.highest, highest_at[i] = result.highest_at;
        // No value found during the search may be higher.
        if (std::isinf(doubtful) || result.highest < amplitude(numbers[2][i]) * (1 - 1e-9))
          peaks.complete[lane_ + i] = false;
        if (band_.count_peaks && !count(heights, doubts, doubtful, result)) peaks.complete[lane_ + i] = false;
      }
      const Pack height = hn::LoadU(Lanes(), highest), omega = hn::LoadU(Lanes(), highest_at);
      store_mask(has_digits_at(c, height, omega, nine_digits), known);
      if (!band_.count_peaks) store_mask(has_digits_at(c, height, omega, seven_digits), some);
      for (int i = 0; i < lanes; ++i) {
        const bool at_end = highest_at[i] == band_.from || highest_at[i] == band_.to;
        ChannelPeaks& result = peaks.channels[c * table_lanes + lane_ + i];
        result.has_few_digits = !band_.count_peaks && !known[i] && some[i] && at_end;
        peaks.complete[lane_ + i] = peaks.complete[lane_ + i] && (known[i] || result.has_few_digits);
      }
    }
  }

 private:
  /// Counts the peaks of one curve from all its heights and their relative errors.
  /// @param doubtful  possible error of a height, as a share of the required rise
  /// @return whether the count and the largest rise are certain
  [[nodiscard]] bool count(const std::vector<double>& heights, const std::vector<double>& doubts, double doubtful,
                           ChannelPeaks& result) const {
    const double least = band_.min_prominence * result.highest;
    assert(heights.size() == doubts.size() && heights.size() >= 2 && "both ends of the band, and what is between");
    const PeakCount found = prominent_peaks(heights, least);
    result.peaks = found.peaks;
    result.largest_rise = found.largest_rise;
    return found.closest >= 2 * doubtful && rise_is_known(heights, doubts, least, found.largest_rise, accuracy_of_rise);
  }

  [[nodiscard]] ScanOptions options() const { return {band_.count_peaks, band_.min_prominence}; }
  [[nodiscard]] Pack* at_start() const { return values_.get(); }
  [[nodiscard]] Pack* at_end() const { return values_.get() + channels_; }
  [[nodiscard]] Pack* at_pole(int k) const { return values_.get() + to_size(2 + k) * to_size(channels_); }
  static double share(double missed, double value) { return missed <= 0 ? 0 : 0.5 * missed / std::abs(value); }
  /// Relative error of a height at an end of the band by round-off.
  [[nodiscard]] Pack doubt_at(int channel, const Pack& x, double omega, const Pack& value) const {
    const SquaredResponse<Size::most>& f = curves_[channel].f;
    if (omega == 0 && ends_[channel].zero_at_start) return hn::Zero(Lanes());
    const Pack missed =
        hn::Mul(hn::Mul(all(0.5), round_off_), std::isinf(omega) ? f.constant_parts : sum_of_moduli(pack_.poles, f, x));
    return hn::IfThenElseZero(hn::Gt(missed, hn::Zero(Lanes())), hn::Div(missed, hn::Abs(value)));
  }
  static double amplitude(double half_square) { return std::sqrt(std::max(2 * half_square, 0.0)); }

  /// Whether a height is known to so many digits.
  [[nodiscard]] LaneMask has_digits_at(int channel, const Pack& height, const Pack& omega, double digits) const {
    const SquaredResponse<Size::most>& f = curves_[channel].f;
    const Pack infinity = all(std::numeric_limits<double>::infinity()),
               value = hn::Mul(all(0.5), hn::Mul(height, height));
    const LaneMask endless = hn::Eq(omega, infinity);
    const Pack moduli = sum_of_moduli(
        pack_.poles, f, hn::IfThenElse(endless, pack_.from, band_.squared ? hn::Mul(omega, omega) : omega));
    return has_digits(hn::IfThenElse(endless, f.constant_parts, moduli), round_off_, value, digits);
  }

  /// Where fractions of near poles nearly cancel, the terms of C do too, and the scan does not know that round-off. It
  /// is largest above these poles. @return lanes in which it does not matter there
  LaneMask known_at_poles() const {
    constexpr double cancelled = 1e3, digits = 1e-9;
    const double low = band_.count_peaks ? low_share * band_.min_prominence : 1e-5;
    const SquarePoles<Size>& poles = pack_.poles;
    LaneMask known = hn::Eq(round_off_, round_off_);
    for (int c = 0; c < channels_; ++c) {
      const SquaredResponse<Size::most>& f = curves_[c].f;
      for (int k = 0; k < poles.count; ++k) {
        const LaneMask doubtful = hn::Gt(f.parts[k], hn::Mul(all(cancelled), sum_of_parts(f.C[k])));
        if (hn::AllFalse(Lanes(), doubtful)) continue;
        const Pack above =
            hn::IfThenElse(poles.real[k], pack_.from, hn::Max(pack_.from, hn::Min(pack_.to, poles.centre[k])));
        const Pack error = hn::Mul(round_off_, sum_of_moduli(poles, f, above));
        const Pack allowed = hn::Max(hn::Mul(all(digits), at_pole(k)[c]), hn::Mul(all(low * low), curves_[c].best));
        known = hn::And(known, hn::Or(hn::Not(doubtful), hn::Le(error, allowed)));
      }
    }
    return known;
  }

  void evaluate_end() {
    if (std::isfinite(band_.to)) {
      update_maxima(pack_, pack_.to, curves_, channels_, at_end());
      return;
    }
    pack_.to = hn::Max(pack_.from, beginning_of_tail(pack_, curves_, ends_, options(), complete_));
    for (int c = 0; c < channels_; ++c) {
      const Pack slope = curves_[c].f.slope;  // positive if the curve grows without bound
      const LaneMask grows = hn::Gt(slope, hn::Zero(Lanes()));
      at_end()[c] = hn::IfThenElse(grows, all(std::numeric_limits<double>::infinity()), curves_[c].f.constant);
      if (band_.count_peaks) complete_ = hn::AndNot(grows, complete_);  // the tail is proven without that growth
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
      for (int k = 0; k < pack_.poles.count; ++k) above[k] = hn::IfThenZeroElse(pack_.poles.real[k], at_pole(k)[c]);
      tops_[c] = find_top(pack_, above, curves_[c]);
    }
    form_zones(pack_.poles, pack_.from, pack_.to, pack_.zones);
    open_zones(pack_, tops_.get(), curves_, channels_);
  }

  const SearchedBand& band_;
  int lane_, channels_;
  const std::vector<CurveEnds>& ends_;
  ScannedPack<Size>& pack_;
  ScannedCurve<Size>* curves_;
  std::unique_ptr<Pack[]> values_;  ///< of all curves at the start, at the end, and at each pole
  std::unique_ptr<Top[]> tops_;
  Pack round_off_;  ///< of sums over the roots, relative to their terms
  LaneMask complete_;
  FoundExtrema found_;
};

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
