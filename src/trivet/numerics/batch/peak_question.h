// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/numerics/peaks/observed_curve.h"
#include "trivet/numerics/roots/root_table.h"

namespace trivet::numerics {

/// Request for every design.
struct PeakQuestion {
  std::vector<ObservedRow> rows;
  double from = 0, to = 0;  ///< [rad/s]
  bool count_peaks = true;
  double min_prominence = 1e-6;
};

/// Result for one channel of one design.
struct ChannelPeaks {
  double highest = 0;
  double highest_at = 0;
  int peaks = 0;
  double largest_rise = 0;
};

/// Channels × designs of a table; `complete`: proven.
struct TablePeaks {
  std::vector<ChannelPeaks> channels;  ///< [channel * table_lanes + lane]
  bool complete[table_lanes];
};

/// Highest values and peaks from the partial fractions of |y|² in ω², eight designs at once.
void peaks_from_roots(const RootTable& table, const PeakQuestion& question, TablePeaks& peaks);

}  // namespace trivet::numerics
