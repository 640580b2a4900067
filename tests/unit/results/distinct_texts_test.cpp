// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <limits>

#include "trivet/results/format/distinct_texts.h"

namespace distinct_texts_test {

using namespace trivet;
using testing::Pair;

TEST(DistinctTexts, HaveEnoughDigitsToDistinguishTwoNumbers) {
  EXPECT_THAT(results::distinct_texts(0.00500025, 0.005, 4), Pair("0.00500025", "0.005"));
  EXPECT_THAT(results::distinct_texts(99.9999, 100.0001, 6), Pair("99.9999", "100.0001"));
  EXPECT_THAT(results::distinct_texts(1, 1.0000000001, 6), Pair("1", "1.0000000001"));
  EXPECT_THAT(results::distinct_texts(3.14159, 2, 4), Pair("3.142", "2"));
}

TEST(DistinctTexts, AreEqualForEqualNumbers) { EXPECT_THAT(results::distinct_texts(0.1, 0.1, 4), Pair("0.1", "0.1")); }

TEST(DistinctTexts, DistinguishAdjacentNumbers) {
  const auto [a, b] = results::distinct_texts(1, 1 + std::numeric_limits<double>::epsilon(), 4);
  EXPECT_NE(a, b);
}

}  // namespace distinct_texts_test
