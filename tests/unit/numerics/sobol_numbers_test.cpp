// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sampling/sobol_numbers.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <bit>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <vector>

#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/sampling/counter_numbers.h"

namespace sobol_numbers_test {

using trivet::numerics::random_words;
using trivet::numerics::RandomPurpose;
using trivet::numerics::SobolNumbers;

std::vector<std::vector<double>> points_of(const SobolNumbers& numbers, std::uint64_t first, std::uint64_t count) {
  std::vector<std::vector<double>> points;
  for (std::uint64_t i = 0; i < count; ++i) numbers.set_point(first + i, points.emplace_back(numbers.dimensions()));
  return points;
}

/// Most points in one of 2^a × 2^b equal cells of two dimensions, and how many cells have points.
std::pair<int, int> filling(const std::vector<std::vector<double>>& points, std::size_t i, std::size_t j, int a,
                            int b) {
  std::vector<int> cells(std::size_t{1} << (a + b));
  for (const auto& point : points)
    ++cells[static_cast<std::size_t>(std::ldexp(point[i], a)) * (std::size_t{1} << b) +
            static_cast<std::size_t>(std::ldexp(point[j], b))];
  return {*std::ranges::max_element(cells),
          static_cast<int>(std::ranges::count_if(cells, [](int n) { return n > 0; }))};
}

/// The points of Boost's sequence, with the one at the origin, which it leaves out.
std::vector<std::vector<double>> plain_points(std::size_t dimensions, int count) {
  boost::random::sobol sequence(dimensions);
  std::vector<std::vector<double>> points = {std::vector<double>(dimensions, 0.0)};
  while (points.size() < static_cast<std::size_t>(count))
    for (double& x : points.emplace_back(dimensions)) x = std::ldexp(static_cast<double>(sequence()), -64);
  return points;
}

TEST(SobolNumbers, FillEveryIntervalOfEveryDimension) {
  constexpr std::size_t dimensions = 200;
  for (const std::uint64_t seed : {1U, 2U, 77U}) {
    const SobolNumbers numbers(dimensions, seed, 3);
    for (int m = 0; m <= 10; ++m)
      for (const std::uint64_t block : {0U, 1U, 5U}) {
        const auto points = points_of(numbers, block << m, std::uint64_t{1} << m);
        for (std::size_t d = 0; d < dimensions; ++d)
          ASSERT_EQ(filling(points, d, d, m, 0).first, 1) << "dimension " << d << ", 2^" << m << " points";
      }
  }
}

TEST(SobolNumbers, FillEveryCellOfTheFirstTwoDimensions) {
  for (const std::uint64_t seed : {1U, 9U})
    for (int m = 0; m <= 12; ++m)
      for (const std::uint64_t block : {0U, 3U}) {
        const auto points = points_of(SobolNumbers(2, seed, 0), block << m, std::uint64_t{1} << m);
        for (int a = 0; a <= m; ++a)
          ASSERT_EQ(filling(points, 0, 1, a, m - a).first, 1) << a << " of " << m << " digits";
      }
}

// A permutation of nested intervals moves points within cells, so that every pair of dimensions is filled as without.
TEST(SobolNumbers, FillCellsOfEveryPairAsTheSequenceWithoutScrambling) {
  constexpr std::size_t dimensions = 12;
  constexpr int m = 10;
  const auto plain = plain_points(dimensions, 1 << m);
  const auto points = points_of(SobolNumbers(dimensions, 4, 1), 0, 1 << m);
  for (std::size_t i = 0; i < dimensions; ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (int a = 0; a <= m; ++a)
        ASSERT_EQ(filling(points, i, j, a, m - a), filling(plain, i, j, a, m - a)) << i << " and " << j;
}

TEST(SobolNumbers, HaveAllPointsAndDimensionsOfTheirTable) {
  constexpr std::size_t dimensions = 3667;
  std::vector<double> point(dimensions);
  SobolNumbers(dimensions, 1, 0).set_point(4294967295U, point);
  for (const double x : point) EXPECT_TRUE(x > 0 && x < 1);
  EXPECT_THROW(SobolNumbers(dimensions + 1, 1, 0), trivet::foundation::InvalidInput);
  EXPECT_THROW(SobolNumbers(0, 1, 0), trivet::foundation::InvalidInput);
  EXPECT_THROW(SobolNumbers(2, 1, 0).set_point(SobolNumbers::most_points, std::span(point).first(2)),
               trivet::foundation::InvalidInput);
}

TEST(SobolNumbers, ScramblingIsANestedPermutation) {
  // Numbers that agree in their first k digits still do, and those that differ in the next one still do.
  std::uint32_t state = 12345;
  const auto next = [&] { return state = state * 1664525U + 1013904223U; };
  for (int repeat = 0; repeat < 2000; ++repeat) {
    const std::uint32_t seed = next(), a = next();
    for (int k = 0; k < 32; ++k) {
      const std::uint32_t tail = k < 31 ? next() >> (k + 1) : 0;
      const std::uint32_t b = ((a ^ (0x80000000U >> k)) & ~(k < 31 ? 0xffffffffU >> (k + 1) : 0U)) | tail;
      const std::uint32_t different = SobolNumbers::scrambled(a, seed) ^ SobolNumbers::scrambled(b, seed);
      ASSERT_EQ(std::countl_zero(different), k);
    }
  }
}

// Owen's scrambling permutes each interval by itself: over many seeds a digit is moved in half of them, and in two
// intervals of the level above independently. The constants that were published first fail this: some digits are moved
// alike in neighbouring intervals.
TEST(SobolNumbers, ScramblingMovesTheDigitsOfEachIntervalByThemselves) {
  constexpr int seeds = 1 << 14;
  constexpr double within = 5 * 0.5 / 128;  // five standard deviations of a share of 2^14
  const auto moved = [](std::uint32_t digits, int k, int s) {
    const std::uint32_t seed = random_words(1, RandomPurpose::scrambling, static_cast<std::uint64_t>(s), 0)[0];
    return ((SobolNumbers::scrambled(digits, seed) ^ digits) >> (31 - k)) & 1U;
  };
  for (int k = 1; k < 12; ++k)
    for (int other = 0; other < k; ++other) {
      const std::uint32_t here = 0x5a5a5a5aU & ~(0xffffffffU >> k), there = here ^ (0x80000000U >> other);
      int ones = 0, alike = 0;
      for (int s = 0; s < seeds; ++s) {
        ones += static_cast<int>(moved(here, k, s));
        alike += moved(here, k, s) == moved(there, k, s) ? 1 : 0;
      }
      EXPECT_NEAR(static_cast<double>(ones) / seeds, 0.5, within) << "digit " << k;
      EXPECT_NEAR(static_cast<double>(alike) / seeds, 0.5, within) << "digit " << k << " beside digit " << other;
    }
}

TEST(SobolNumbers, HaveAMeanFarNearerThanRandomNumbers) {
  // Of 2^10 points in as many intervals, each at random in its own: 2⁻¹⁰/√12 · 2⁻⁵ = 9e-6.
  const auto points = points_of(SobolNumbers(6, 1, 0), 0, 1024);
  for (std::size_t d = 0; d < 6; ++d) {
    double mean = 0;
    for (const auto& point : points) mean += point[d] / 1024;
    EXPECT_NEAR(mean, 0.5, 5e-5);
  }
}

// The same point of two scramblings: its covariance is that of uniform numbers if these are one, 1/12, and 0 if they
// are independent, over many scramblings.
TEST(SobolNumbers, AreIndependentBetweenScramblings) {
  constexpr int pairs = 2000;
  std::vector<double> product(4, 0.0);
  for (int s = 0; s < pairs; ++s) {
    const auto a = points_of(SobolNumbers(4, 1, 2 * s), 5, 1).front();
    const auto b = points_of(SobolNumbers(4, 1, 2 * s + 1), 5, 1).front();
    for (std::size_t d = 0; d < 4; ++d) product[d] += (a[d] - 0.5) * (b[d] - 0.5) / pairs;
  }
  for (const double covariance : product) EXPECT_NEAR(covariance, 0, 5.0 / 12 / std::sqrt(pairs));
}

TEST(SobolNumbers, DoNotDependOnTheOrder) {
  const SobolNumbers numbers(7, 5, 2);
  const auto ahead = points_of(numbers, 0, 300);
  for (int i = 299; i >= 0; --i) EXPECT_EQ(points_of(numbers, i, 1).front(), ahead[i]);
}

}  // namespace sobol_numbers_test
