// SPDX-License-Identifier: BSD-3-Clause
// Orders together in time, against closed forms and a fine scan of one period.
#include "trivet/response/machinery/orders_in_time.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

namespace {

using trivet::response::OrdersInTime;
using trivet::response::RangeInTime;

constexpr double accuracy = 1e-10;  // of a search to 1e-11 of the sum of the amplitudes
const std::complex<double> i(0, 1);

RangeInTime range(const std::vector<double>& orders, const std::vector<std::complex<double>>& amplitudes) {
  return OrdersInTime(orders).range(Eigen::VectorXcd::Map(amplitudes.data(), static_cast<int>(amplitudes.size())));
}

TEST(OrdersInTime, OfOneOrderIsItsAmplitude) {
  const RangeInTime found = range({3}, {3.0 + 4.0 * i});
  EXPECT_DOUBLE_EQ(found.peak(), 5);
  EXPECT_DOUBLE_EQ(found.span(), 10);
}

TEST(OrdersInTime, OfCosinesOfOnceAndTwiceIsTheClosedForm) {
  for (const auto& orders : {std::vector<double>{1, 2}, {0.5, 1}, {23.0 / 37, 46.0 / 37}}) {
    const RangeInTime found = range(orders, {1, 1});  // 2c² + c − 1 with c = cos φ
    EXPECT_NEAR(found.largest, 2, accuracy);
    EXPECT_NEAR(found.least, -9.0 / 8, accuracy);
    EXPECT_NEAR(found.peak(), 2, accuracy);
    EXPECT_NEAR(found.span(), 25.0 / 8, accuracy);
    EXPECT_NEAR(range(orders, {-1, -1}).peak(), 2, accuracy);
  }
}

TEST(OrdersInTime, DependsOnThePhases) {
  // cos φ − cos 3φ = 4c − 4c³, largest at c² = 1/3; with + it is 2 at φ = 0.
  EXPECT_NEAR(range({1, 3}, {1, -1}).peak(), 8 / std::sqrt(27), accuracy);
  EXPECT_NEAR(range({1, 3}, {1, 1}).peak(), 2, accuracy);
  // sin φ + sin 2φ: its slope is 4c² + c − 2.
  const double c = (std::sqrt(33) - 1) / 8, s = std::sqrt(1 - c * c);
  EXPECT_NEAR(range({1, 2}, {-i, -i}).peak(), s + 2 * s * c, accuracy);
}

TEST(OrdersInTime, WithoutACommonPeriodTheRangesAdd) {
  EXPECT_NEAR(range({1, std::numbers::sqrt2}, {1, -2.0 * i}).peak(), 3, accuracy);
  const RangeInTime found = range({1, std::numbers::sqrt2, 2}, {1, 0.5, 1});
  EXPECT_NEAR(found.largest, 2.5, accuracy);
  EXPECT_NEAR(found.least, -9.0 / 8 - 0.5, accuracy);
}

TEST(OrdersInTime, IsInfiniteWithAnAmplitude) {
  EXPECT_TRUE(std::isinf(range({1, 2}, {1, std::numeric_limits<double>::infinity()}).peak()));
}

TEST(OrdersInTime, OfAnyOrdersIsThatOfAFineScan) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const std::vector<double> orders = {0.5, 1, 1.5, 2, 37.0 / 23, 6};  // period: 46 turns
  constexpr int turns = 46, steps = 400'000;
  for (int trial = 0; trial < 4; ++trial) {
    std::vector<std::complex<double>> y;
    for (std::size_t k = 0; k < orders.size(); ++k) y.emplace_back(normal(random), normal(random));
    double least = 0, largest = 0;
    for (int n = 0; n < steps; ++n) {
      std::complex<double> sum = 0;
      for (std::size_t k = 0; k < orders.size(); ++k)
        sum += y[k] * std::exp(2 * std::numbers::pi * turns * n / steps * orders[k] * i);
      least = std::min(least, sum.real());
      largest = std::max(largest, sum.real());
    }
    const RangeInTime found = range(orders, y);
    const double scanned = 1e-4;  // (6 · step)²/8 Σ|y|, with a margin
    EXPECT_GE(found.largest, largest - accuracy);
    EXPECT_NEAR(found.largest, largest, scanned);
    EXPECT_LE(found.least, least + accuracy);
    EXPECT_NEAR(found.least, least, scanned);
  }
}

}  // namespace
