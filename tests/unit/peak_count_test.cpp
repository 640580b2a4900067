// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/peak_count.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace {

using trivet::numerics::prominent_peaks;

TEST(PeakCount, RisesOverTheHigherOfBothMinima) {
  const std::vector<double> heights = {1, 5, 2, 3, 0};
  const auto count = prominent_peaks(heights, 0.5);
  EXPECT_EQ(count.peaks, 2);
  EXPECT_DOUBLE_EQ(count.largest_rise, 4);  // 5 over 1
  EXPECT_EQ(prominent_peaks(heights, 1.5).peaks, 1);
}

TEST(PeakCount, TellsHowNearlyItWasDecided) {
  const std::vector<double> heights = {1, 5, 2, 3, 0};  // prominences 4 and 1
  EXPECT_DOUBLE_EQ(prominent_peaks(heights, 0.8).closest, 0.25);
  EXPECT_DOUBLE_EQ(prominent_peaks(heights, 1.25).closest, 0.2);
  EXPECT_EQ(prominent_peaks({heights.data(), 2}, 1).closest, std::numeric_limits<double>::infinity());  // no maximum between its ends
}

TEST(PeakCount, AnInfiniteHeightAlwaysCounts) {
  const std::vector<double> heights = {1, std::numeric_limits<double>::infinity(), 2};
  EXPECT_EQ(prominent_peaks(heights, 1e300).peaks, 1);
}

}  // namespace
