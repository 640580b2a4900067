// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sampling/exact_statistics.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/sampling/counter_numbers.h"

namespace exact_statistics_test {

using trivet::numerics::ExactSum;
using trivet::numerics::Extremes;
using trivet::numerics::LogHistogram;

/// Numbers of both signs over six decades, and their exact sum as all are multiples of 2⁻⁴⁰.
std::vector<double> numbers(int count) {
  std::vector<double> list;
  for (int i = 0; i < count; ++i) {
    const double x = trivet::numerics::random_number(1, i, 0), y = trivet::numerics::random_number(1, i, 1);
    list.push_back(std::ldexp(std::rint(std::ldexp((x - 0.5) * std::pow(10, 6 * y), 40)), -40));
  }
  return list;
}

/// All statistics of numbers in some order, in parts that are merged in another.
struct Statistics {
  explicit Statistics(double magnitude) : sum(magnitude) {}
  ExactSum sum;
  LogHistogram histogram;
  Extremes extremes;
  void merge(const Statistics& other) {
    sum.merge(other.sum);
    histogram.merge(other.histogram);
    extremes.merge(other.extremes);
  }
};

TEST(ExactStatistics, DoNotDependOnOrderAndParts) {
  const std::vector<double> list = numbers(4000);
  Statistics whole(100);
  for (std::size_t i = 0; i < list.size(); ++i) {
    whole.sum.add(list[i]);
    whole.histogram.add(list[i]);
    whole.extremes.add(list[i], i);
  }
  for (const std::size_t parts : {1U, 3U, 7U, 64U}) {
    Statistics merged(100);
    for (std::size_t part = parts; part-- > 0;) {
      Statistics one(100);
      for (std::size_t i = list.size(); i-- > 0;) {
        if (i % parts != part) continue;
        one.sum.add(list[i]);
        one.histogram.add(list[i]);
        one.extremes.add(list[i], i);
      }
      merged.merge(one);
    }
    EXPECT_EQ(merged.sum, whole.sum);
    EXPECT_EQ(merged.histogram, whole.histogram);
    EXPECT_EQ(merged.extremes, whole.extremes);
  }
}

TEST(ExactSum, IsTheSumOfRoundedNumbers) {
  long double exact = 0;
  ExactSum sum(5e5);
  for (const double x : numbers(4000)) {
    exact += x;
    sum.add(x);
  }
  // 4000 numbers with half a unit of 2^19 · 2⁻⁶⁴ each, and the rounding of the result.
  EXPECT_NEAR(sum.value(), static_cast<double>(exact), 4000 * 0x1p-46 + 1e-16 * std::abs(static_cast<double>(exact)));
  EXPECT_FALSE(sum.saturated());
}

TEST(ExactSum, KeepsWhatSumsOfDoublesLose) {
  ExactSum sum(1);
  sum.add(0x1p20);
  for (int i = 0; i < 1000; ++i) sum.add(0x1p-60);
  sum.add(-0x1p20);
  EXPECT_EQ(sum.value(), 1000 * 0x1p-60);
}

TEST(ExactSum, SaturatesInAnyOrder) {
  ExactSum up(1), down(1);
  for (const double x : {1e300, -1e300, 1.0}) up.add(x);
  for (const double x : {1.0, -1e300, 1e300}) down.add(x);
  EXPECT_TRUE(up.saturated());
  EXPECT_EQ(up, down);
  ExactSum infinite(1);
  infinite.add(std::numeric_limits<double>::infinity());
  EXPECT_TRUE(infinite.saturated());
  EXPECT_THROW(up.merge(ExactSum(4)), trivet::foundation::InvalidInput);
  EXPECT_THROW(ExactSum(0), trivet::foundation::InvalidInput);
}

TEST(LogHistogram, HasQuantilesWithinItsRelativeError) {
  std::vector<double> list = numbers(5001);
  LogHistogram histogram;
  for (const double x : list) histogram.add(x);
  std::ranges::sort(list);
  for (const double share : {0.0, 0.001, 0.05, 0.3, 0.5, 0.77, 0.95, 1.0}) {
    const double exact = list[static_cast<std::size_t>(std::max(1.0, std::ceil(share * 5001))) - 1];
    EXPECT_NEAR(histogram.quantile(share), exact, LogHistogram::relative_error * std::abs(exact)) << share;
  }
}

TEST(LogHistogram, HasPlacesForZeroAndInfinity) {
  LogHistogram histogram;
  EXPECT_TRUE(std::isnan(histogram.quantile(0.5)));
  for (const double x : {0.0, -0.0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                         5e-324, 1.7e308, -3.0})
    histogram.add(x);
  EXPECT_EQ(histogram.count(), 7);
  EXPECT_EQ(histogram.quantile(0), -std::numeric_limits<double>::infinity());
  EXPECT_NEAR(histogram.quantile(0.2), -3, 3e-3);
  EXPECT_EQ(histogram.quantile(0.4), 0);
  EXPECT_NEAR(histogram.quantile(0.8) / 1.7e308, 1, 1e-3);
  EXPECT_EQ(histogram.quantile(1), std::numeric_limits<double>::infinity());
}

TEST(Extremes, NameTheFirstDesign) {
  Extremes extremes;
  for (const auto& [x, i] : {std::pair(3.0, 8), {1.0, 7}, {3.0, 2}, {1.0, 9}}) extremes.add(x, i);
  EXPECT_EQ(extremes.least_at, 7);
  EXPECT_EQ(extremes.largest_at, 2);
}

/// Read again from their words.
template <typename Statistic>
Statistic stored_and_restored(const Statistic& statistic) {
  trivet::foundation::StoredWords words;
  statistic.store(words);
  trivet::foundation::WordReader reader(words.words());
  Statistic found = Statistic::restored(reader);
  reader.end();
  return found;
}

TEST(StoredStatistics, AreTheSameAndCanBeMerged) {
  const std::vector<double> list = numbers(2000);
  Statistics first(1e6), all(1e6), second(1e6);
  for (std::size_t i = 0; i < list.size(); ++i)
    for (Statistics* one : {&all, i < 900 ? &first : &second}) {
      one->sum.add(list[i]);
      one->histogram.add(list[i]);
      one->extremes.add(list[i], i);
    }
  Statistics merged(1e6);
  merged.sum = stored_and_restored(first.sum);
  merged.histogram = stored_and_restored(first.histogram);
  merged.extremes = stored_and_restored(first.extremes);
  merged.merge(second);
  EXPECT_LT(first.sum.value(), 1e9);
  EXPECT_EQ(merged.sum, all.sum);
  EXPECT_EQ(merged.histogram, all.histogram);
  EXPECT_EQ(merged.extremes, all.extremes);
}

TEST(StoredStatistics, AreTheSameAtTheirEnds) {
  ExactSum saturated(1e-300), negative(1);
  saturated.add(-1);
  negative.add(-0.75);
  EXPECT_EQ(stored_and_restored(saturated), saturated);
  EXPECT_EQ(stored_and_restored(negative).value(), -0.75);
  LogHistogram histogram;
  for (const double one : {-HUGE_VAL, -1e300, 0.0, 5e-324, 1.0, HUGE_VAL}) histogram.add(one, 3);
  EXPECT_EQ(stored_and_restored(histogram), histogram);
  EXPECT_EQ(stored_and_restored(histogram).count(), 18);
  EXPECT_EQ(stored_and_restored(Extremes()), Extremes());
}

}  // namespace exact_statistics_test
