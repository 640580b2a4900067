// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/amplitude_range.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

/// The same facts as web/tests/amplitude_range_test.ts.
namespace amplitude_range_test {

using namespace trivet;
using report::AmplitudeRange;

/// Curves over 0 … 1.
AmplitudeRange range_of(const std::vector<std::function<double(double)>>& curves) {
  std::vector<double> at;
  for (int i = 0; i <= 1000; ++i) at.push_back(i / 1000.0);
  std::vector<std::vector<double>> heights;
  for (const auto& curve : curves) {
    heights.emplace_back();
    for (const double x : at) heights.back().push_back(curve(x));
  }
  std::vector<report::DrawnAmplitudes> drawn;
  for (const auto& amplitude : heights) drawn.push_back({at, amplitude});
  return amplitude_range(drawn);
}

double constant(double) { return 1; }
double with_dip(double x) { return std::abs(x - 0.5) < 0.04 ? 1e-6 : 1; }

TEST(AmplitudeRange, IsWideIfAmplitudesFallByTwoDecadesOverNineTenthsOfTheBand) {
  EXPECT_TRUE(range_of({[](double x) { return std::pow(10, -2.1 / 0.9 * x); }}).is_wide());
  EXPECT_FALSE(range_of({[](double x) { return std::pow(10, -1.9 / 0.9 * x); }}).is_wide());
  const AmplitudeRange range = range_of({[](double x) { return std::pow(10, -4 * x); }});
  constexpr double one_step = 0.02;  // of the thousand points
  EXPECT_EQ(range.largest, 1);
  EXPECT_NEAR(range.least / std::pow(10, -3.6), 1, one_step);
  EXPECT_DOUBLE_EQ(range.bottom, 1e-4);
}

TEST(AmplitudeRange, IsDecidedNeitherByADipNorByACurveThatNowhereMatters) {
  EXPECT_FALSE(range_of({with_dip}).is_wide());
  EXPECT_DOUBLE_EQ(range_of({with_dip}).bottom, 0.1) << "a decade below the least that matters";
  EXPECT_FALSE(range_of({constant, [](double) { return 5e-4; }}).is_wide());
  EXPECT_TRUE(range_of({constant, [](double) { return 5e-3; }}).is_wide());
  EXPECT_EQ(range_of({[](double x) { return x == 0 ? 0.0 : 1.0; }}).bottom, 1) << "0 is on no logarithmic axis";
}

TEST(AmplitudeRange, IsWideWithAnInfinitePeakAndIgnoresGaps) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const AmplitudeRange range = range_of({[](double x) { return x == 0.5 ? infinity : 1; }});
  EXPECT_TRUE(range.is_wide());
  EXPECT_EQ(range.largest, 1);
  EXPECT_FALSE(range_of({[](double x) { return x == 0.5 ? std::nan("") : 1; }}).is_wide());
}

TEST(AmplitudeRange, CountsAGapAsNoPartOfTheBand) {
  const auto interrupted = [](double x) { return x < 0.1 ? 1 : x <= 0.95 ? std::nan("") : 1e-3; };
  EXPECT_TRUE(range_of({interrupted}).is_wide()) << "the low part has a third of the band, not a twentieth";
}

TEST(AmplitudeRange, OfNothingIsNotWide) {
  EXPECT_FALSE(range_of({}).is_wide());
  EXPECT_FALSE(range_of({[](double) { return 0.0; }}).is_wide());
}

}  // namespace amplitude_range_test
