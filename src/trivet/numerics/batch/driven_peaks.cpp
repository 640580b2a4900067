// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/batch/driven_peaks.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <vector>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/batch/driven_curves-inl.h"
#include "trivet/numerics/batch/driven_peaks.h"
#include "trivet/numerics/batch/driven_values.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

template <typename Size, typename Poles>
void search_driven(Size n, Poles, const DrivenDesigns& designs, const std::vector<CurveEnds>& ends,
                   const SearchedBand& band, Eigen::Index first, int lane, TablePeaks& peaks) {
  FormedCurves<Poles> formed(ends);
  DrivenCurves<Size, Poles>(n, designs, first + lane).form(formed);
  CurveSearch<Poles> curves(formed, band, lane);
  curves.search();
  curves.write_peaks(peaks);
}

void driven_peaks_in_lanes(int n, const DrivenDesigns& designs, const std::vector<CurveEnds>& ends,
                           const SearchedBand& band, Eigen::Index first, TablePeaks& peaks) {
  peaks.channels.resize(ends.size() * table_lanes);
  assert(n >= 1 && n <= most_driven_coordinates && ends.size() == designs.curves.size() && !band.squared);
  for (int lane = 0; lane < table_lanes; lane += lane_count())
    n == 6 ? search_driven(six_coordinates(), AtMost<12>{12}, designs, ends, band, first, lane, peaks)
           : search_driven(AtMostTwelve{n}, AtMost<24>{2 * n}, designs, ends, band, first, lane, peaks);
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "trivet/numerics/lanes/dispatch.h"

namespace trivet::numerics {

TRIVET_VARIANTS(driven_peaks_in_lanes);

namespace {

static_assert(most_driven_coordinates == most_pairs);

[[noreturn]] void reject(const char* rule) {
  throw foundation::InvalidInput(std::string("peaks of driven designs: ") + rule);
}

/// Sums of the powers of a row of a curve and of its load.
struct SumsOfPowers {
  int least = most_power_in_band, most = least_power;
};

SumsOfPowers sums_of_powers(const DrivenDesigns& designs, const DesignCurve& curve, bool in_band) {
  SumsOfPowers sums;
  for (const DesignTerm& row : curve.rows)
    for (const DesignTerm& value : designs.loads.at(curve.load)) {
      const int sum = row.power + value.power;
      if (sum < least_power || sum > (in_band ? most_power_in_band : most_power))
        reject(
            "the powers of s of a row and a load must add up to 0, 1 or 2, or up to 4 without peaks in a finite band");
      sums = {std::min(sums.least, sum), std::max(sums.most, sum)};
    }
  return sums;
}

CurveEnds ends_of(const DrivenDesigns& designs, const DesignCurve& curve, const DrivenPeakOptions& options) {
  const SumsOfPowers sums = sums_of_powers(designs, curve, !options.count_peaks && std::isfinite(options.to));
  const bool constant = (curve.constant_re != 0).any() || (curve.constant_im != 0).any();
  return {.zero_at_start = !constant && options.from == 0 && sums.least > 0,
          .flat_at_infinity = !constant && sums.most < most_power};
}

Eigen::Index checked_coordinates(const DrivenDesigns& designs, const DrivenPeakOptions& options) {
  const Eigen::Index n = coordinates_of(designs.A.cols()), count = designs.count();
  if (n < 1 || n > most_driven_coordinates) reject("one to twelve coordinates are possible");
  const auto fits = [&](const Eigen::ArrayXXd& numbers, Eigen::Index columns) {
    return numbers.cols() == columns && (numbers.rows() == count || numbers.rows() == 1);
  };
  for (const Eigen::ArrayXXd* m : {&designs.A, &designs.B, &designs.K})
    if (!fits(*m, designs.A.cols())) reject("A, B and K must have one row for every design");
  if (designs.D.size() > 0 && !fits(designs.D, designs.A.cols())) reject("D must be empty or like K");
  const auto check = [&](const std::vector<DesignTerm>& terms) {
    for (const DesignTerm& term : terms)
      if (!fits(term.re, n) || !fits(term.im, n)) reject("a term must have one number for every coordinate");
  };
  for (const std::vector<DesignTerm>& load : designs.loads) check(load);
  for (const DesignCurve& curve : designs.curves) {
    check(curve.rows);
    if (curve.load >= designs.loads.size()) reject("a curve names a load that does not exist");
    if (!fits(curve.constant_re, 1) || !fits(curve.constant_im, 1)) reject("a curve must have one constant");
  }
  if (!(options.from >= 0) || !(options.to > options.from)) reject("the band must satisfy 0 ≤ from < to");
  if (!(options.min_prominence >= 0)) reject("the prominence must be a share ≥ 0");
  return n;
}

}  // namespace

DesignPeaks driven_peaks(const DrivenDesigns& designs, const DrivenPeakOptions& options) {
  const auto n = static_cast<int>(checked_coordinates(designs, options));
  const SearchedBand band{options.from, options.to, options.count_peaks, options.min_prominence, false};
  std::vector<CurveEnds> ends;
  for (const DesignCurve& curve : designs.curves) ends.push_back(ends_of(designs, curve, options));
  const Eigen::Index count = designs.count(), channels = to_index(ends.size());
  DesignPeaks result{Eigen::ArrayXXd::Zero(count, channels),
                     Eigen::ArrayXXd::Zero(count, channels),
                     {},
                     {},
                     std::vector<DesignStatus>(to_size(count), DesignStatus::undecided)};
  if (options.count_peaks) {
    result.peaks.setZero(count, channels);
    result.largest_rise.setZero(count, channels);
  }
  TablePeaks found;
  for (Eigen::Index first = 0; first < count; first += table_lanes) {
    TRIVET_DISPATCH(driven_peaks_in_lanes)(n, designs, ends, band, first, found);
    for (Eigen::Index d = first; d < std::min(first + table_lanes, count); ++d) {
      if (!found.complete[d - first]) continue;
      result.status[d] = DesignStatus::proven;
      for (Eigen::Index c = 0; c < channels; ++c) {
        const ChannelPeaks& of = found.channels[c * table_lanes + (d - first)];
        result.highest(d, c) = of.has_few_digits ? driven_magnitudes(designs, d, of.highest_at)(c) : of.highest;
        result.highest_at(d, c) = of.highest_at;
        if (!options.count_peaks) continue;
        result.peaks(d, c) = of.peaks;
        result.largest_rise(d, c) = of.largest_rise;
      }
    }
  }
  return result;
}

}  // namespace trivet::numerics
#endif
