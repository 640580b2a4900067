// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <limits>

#include "trivet/results/shown_apart.h"

namespace {

using namespace trivet;
using testing::Pair;

TEST(ShownApart, TakesTheDigitsThatTellTwoNumbersApart) {
  EXPECT_THAT(results::shown_apart(0.00500025, 0.005, 4), Pair("0.00500025", "0.005"));
  EXPECT_THAT(results::shown_apart(99.9999, 100.0001, 6), Pair("99.9999", "100.0001"));
  EXPECT_THAT(results::shown_apart(1, 1.0000000001, 6), Pair("1", "1.0000000001"));
  EXPECT_THAT(results::shown_apart(3.14159, 2, 4), Pair("3.142", "2"));
}

TEST(ShownApart, EndsWhereTwoNumbersAreOne) { EXPECT_THAT(results::shown_apart(0.1, 0.1, 4), Pair("0.1", "0.1")); }

TEST(ShownApart, TellsNeighboursApart) {
  const auto [a, b] = results::shown_apart(1, 1 + std::numeric_limits<double>::epsilon(), 4);
  EXPECT_NE(a, b);
}

}  // namespace
