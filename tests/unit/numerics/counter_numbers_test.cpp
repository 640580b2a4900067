// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sampling/counter_numbers.h"

#include <gmock/gmock.h>

#include <cmath>

namespace counter_numbers_test {

using trivet::numerics::random_number;
using trivet::numerics::random_words;
using trivet::numerics::RandomPurpose;

// Known answers of Random123 (kat_vectors): counter and key of zeros.
TEST(CounterNumbers, AreThoseOfPhilox) {
  EXPECT_THAT(random_words(0, RandomPurpose{0}, 0, 0),
              testing::ElementsAre(0x6627e8d5U, 0xe169c58dU, 0xbc57ac4cU, 0x9b00dbd8U));
  EXPECT_THAT(random_words(0xffffffffffffffffU, RandomPurpose{0xffffffffU}, 0xffffffffffffffffU, 0xffffffffU),
              testing::ElementsAre(0x408f276dU, 0x41c83b0eU, 0xa20bc7c6U, 0x6d5451fdU));
}

TEST(CounterNumbers, AreUniformInTheOpenInterval) {
  constexpr int count = 100000, cells = 50;
  std::array<int, cells> in_cell{};
  for (int i = 0; i < count; ++i) {
    const double x = random_number(3, i, 1);
    ASSERT_TRUE(x > 0 && x < 1);
    ++in_cell[static_cast<std::size_t>(x * cells)];
  }
  double chi_squared = 0;
  for (const int n : in_cell) chi_squared += std::pow(n - count / cells, 2) / (count / cells);
  EXPECT_GT(chi_squared, 23.98);  // 0.1 % and 99.9 % quantiles with 49 degrees of freedom
  EXPECT_LT(chi_squared, 85.35);
}

TEST(CounterNumbers, DifferInSeedIndexAndDimension) {
  const double x = random_number(1, 2, 3);
  EXPECT_EQ(random_number(1, 2, 3), x);
  EXPECT_NE(random_number(2, 2, 3), x);
  EXPECT_NE(random_number(1, 3, 3), x);
  EXPECT_NE(random_number(1, 2, 4), x);
  EXPECT_NE(random_number(1, 2 + (std::uint64_t{1} << 32), 3), x);
}

}  // namespace counter_numbers_test
