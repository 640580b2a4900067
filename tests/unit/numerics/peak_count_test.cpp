// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/peaks/peak_count.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

namespace peak_count_test {

using trivet::numerics::prominent_peaks;
using trivet::numerics::rise_is_known;

TEST(PeakCount, RisesOverTheHigherOfBothMinima) {
  const std::vector<double> heights = {1, 5, 2, 3, 0};
  const auto count = prominent_peaks(heights, 0.5);
  EXPECT_EQ(count.peaks, 2);
  EXPECT_DOUBLE_EQ(count.largest_rise, 4);  // 5 over 1
  EXPECT_EQ(prominent_peaks(heights, 1.5).peaks, 1);
}

TEST(PeakCount, ReportsHowCloseTheDecisionWas) {
  const std::vector<double> heights = {1, 5, 2, 3, 0};  // prominences 4 and 1
  EXPECT_DOUBLE_EQ(prominent_peaks(heights, 0.8).closest, 0.25);
  EXPECT_DOUBLE_EQ(prominent_peaks(heights, 1.25).closest, 0.2);
  EXPECT_EQ(prominent_peaks({heights.data(), 2}, 1).closest,
            std::numeric_limits<double>::infinity());  // no maximum between its ends
}

TEST(PeakCount, AnInfiniteHeightAlwaysCounts) {
  const std::vector<double> heights = {1, std::numeric_limits<double>::infinity(), 2};
  EXPECT_EQ(prominent_peaks(heights, 1e300).peaks, 1);
}

/// Peaks of 5 over 1 and of 3 over 2, whose rises are 4 and 0.5.
TEST(RiseIsKnown, IfThePeakAndItsBaseAreKnown) {
  const std::vector<double> heights = {1, 5, 2, 3, 0};
  const auto known = [&](const std::vector<double>& doubts) { return rise_is_known(heights, doubts, 0.5, 4, 1e-6); };
  EXPECT_TRUE(known({0, 1e-9, 0, 0, 0}));
  EXPECT_FALSE(known({0, 1e-5, 0, 0, 0}));  // uncertain peak
  EXPECT_FALSE(known({1e-5, 0, 0, 0, 0}));  // uncertain base
  EXPECT_TRUE(known({0, 0, 0.1, 0.1, 0}));  // a peak that stays far below
  EXPECT_FALSE(known({0, 0, 1, 1, 0}));     // a peak that may not
}

TEST(RiseIsKnown, OverABaseOfExactlyZeroOnly) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(rise_is_known(std::vector<double>{0, 5, 0}, std::vector<double>{0, 0, 0}, 0.5, infinity, 1e-6));
  EXPECT_FALSE(
      rise_is_known(std::vector<double>{0, 5, 0, 6, 7}, std::vector<double>{0, 0, 1e-3, 0, 0}, 0.5, infinity, 1e-6));
  EXPECT_FALSE(rise_is_known(std::vector<double>{2, 6, 0, 5, 0}, std::vector<double>{0, 0, 1e-3, 0, 0}, 0.5, infinity,
                             1e-6));  // between it and a true zero
}

TEST(RiseIsKnown, OverTheHigherOfTwoUncertainMinima) {
  const std::vector<double> heights = {7, 1, 5, 0.9, 6};
  EXPECT_TRUE(rise_is_known(heights, std::vector<double>{0, 0, 0, 0.01, 0}, 0.5, 4, 1e-6));
  EXPECT_FALSE(rise_is_known(heights, std::vector<double>{0, 0, 0, 0.1, 0}, 0.5, 4, 1e-6));
}

TEST(Prominences, AreThoseOfEachPoint) {
  std::mt19937 random(7);
  for (const int levels : {2, 5, 1000}) {  // with many equal heights, and with few
    std::vector<double> heights(200);
    for (double& height : heights) height = std::uniform_int_distribution<int>(0, levels)(random);
    heights[90] = std::numeric_limits<double>::infinity();
    const std::vector<double> all = trivet::numerics::prominences(heights);
    ASSERT_EQ(all.size(), heights.size());
    for (std::size_t i = 0; i < heights.size(); ++i) EXPECT_EQ(all[i], trivet::numerics::prominence(heights, i)) << i;
  }
  EXPECT_TRUE(trivet::numerics::prominences({}).empty());
}

}  // namespace peak_count_test
