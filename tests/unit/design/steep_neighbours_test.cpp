// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "trivet/design/drawn_grid.h"

namespace steep_neighbours_test {

using namespace trivet;
using Kind = design::DesignRule::Kind;

constexpr std::uint8_t amplitude = 0, no_peak = 1;
const std::vector<design::MapRule> rules = {{Kind::amplitude, "a.z", "m", 0.01, "a.z ≤ 0.01 m"},
                                            {Kind::no_peak, "a.z", "m", 0.01, "no peak of a.z"}};

/// Steep pairs of two designs side by side; must be the same for one above the other.
std::size_t steep(const design::DesignOutcome& a, const design::DesignOutcome& b) {
  const std::size_t beside = design::steep_neighbours({2, 1}, rules, {a, b});
  EXPECT_EQ(design::steep_neighbours({1, 2}, rules, {a, b}), beside);
  EXPECT_EQ(design::steep_neighbours({2, 1}, rules, {b, a}), beside);
  return beside;
}

TEST(SteepNeighbours, DifferMoreThanTenfold) {
  EXPECT_EQ(steep({0.5F, amplitude}, {5.5F, amplitude}), 1u);
  EXPECT_EQ(steep({0.5F, amplitude}, {5, amplitude}), 0u);
}

TEST(SteepNeighbours, AreBothGovernedByAmplitudeLimits) {
  EXPECT_EQ(steep({0.5F, amplitude}, {50, no_peak}), 0u);
  EXPECT_EQ(steep({0.5F, no_peak}, {50, no_peak}), 0u);
}

TEST(SteepNeighbours, MayHaveZeroMarginOnOneSide) {
  EXPECT_EQ(steep({0, amplitude}, {0.1F, amplitude}), 1u);  // an unbounded amplitude
  EXPECT_EQ(steep({0, amplitude}, {0, amplitude}), 0u);
}

TEST(SteepNeighbours, HaveKnownFiniteMargins) {
  EXPECT_EQ(steep({0.5F, amplitude}, {std::numeric_limits<float>::infinity(), amplitude}), 0u);
  EXPECT_EQ(steep({0.5F, amplitude}, {0, design::DesignOutcome::no_model}), 0u);
}

TEST(SteepNeighbours, AreNotAcrossACorner) {
  const design::DesignOutcome low{1, amplitude}, middle{5, amplitude}, high{25, amplitude};
  EXPECT_EQ(design::steep_neighbours({2, 2}, rules, {low, middle, middle, high}), 0u);
  EXPECT_EQ(design::steep_neighbours({2, 2}, rules, {low, high, middle, high}), 1u);
  EXPECT_EQ(design::steep_neighbours({3, 1}, rules, {low, high, low}), 2u);
}

}  // namespace steep_neighbours_test
