// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "trivet/numerics/peaks/extremum.h"
#include "trivet/numerics/roots/root_table.h"

namespace trivet::numerics {

/// What is searched for, and where.
struct SearchedBand {
  double from = 0, to = 0;  ///< [rad/s]
  bool count_peaks = true;
  double min_prominence = 1e-6;
  bool squared = true;  ///< the variable of the search is x = ω², else x = ω

  [[nodiscard]] double x(double omega) const { return squared ? omega * omega : omega; }
  [[nodiscard]] double omega(double x) const { return squared ? std::sqrt(x) : x; }
};

/// Known behaviour of a |y|² at the ends of the axis.
struct CurveEnds {
  bool zero_at_start = false;     ///< exactly 0 at the start of the band, and rising
  bool flat_at_infinity = false;  ///< falls at least like x^−2, so that its slope in 1/x vanishes at x = ∞
  int powers_of_x = 0;            ///< the curve is x^powers times one that is a proper partial fraction
};

/// Request for every design.
struct PeakRequest {
  std::vector<ObservedRow> rows;
  SearchedBand band;
};

/// Result for one channel of one design.
struct ChannelPeaks {
  double highest = 0;
  double highest_at = 0;
  int peaks = 0;
  double largest_rise = 0;
  /// Without peaks: the highest value is the one at an end of the band, and there the fractions cancel so far that it
  /// has seven digits instead of nine.
  bool has_few_digits = false;
};

/// Channels × designs of a table; `complete`: proven.
struct TablePeaks {
  std::vector<ChannelPeaks> channels;  ///< [channel * table_lanes + lane]
  bool complete[table_lanes];
};

/// Highest values and peaks from the partial fractions of |y|² in ω², eight designs at once.
void peaks_from_roots(const RootTable& table, const PeakRequest& request, TablePeaks& peaks);

/// A zero of the slope of one curve in one lane, or an x near it.
struct FoundExtremum {
  int lane = 0;
  int channel = 0;
  double at = 0;     ///< x, ω² or ω
  double lower = 0;  ///< ends of its panel
  double upper = 0;
  bool maximum = false;
  double value = 0;   ///< half of |y|², after refinement
  double missed = 0;  ///< error of `value`: change by a further step, and round-off
};

using FoundExtrema = std::vector<FoundExtremum>;

}  // namespace trivet::numerics
