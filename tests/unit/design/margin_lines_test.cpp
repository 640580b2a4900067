// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "support/map_outcomes.h"
#include "trivet/design/margin_lines.h"

namespace margin_lines_test {

using namespace trivet;
using test::outcomes;
using test::unlimited;

constexpr double round_off = 1e-15;  // a few operations on numbers from 0 to 1
/// Margins up to 4 are stored as floats of 6e-8; the lines interpolate their logarithms, which is exact here.
constexpr double float_margins = 1e-5;

TEST(DrawnGrid, ContainsBothEndsAndMapsItsPlaces) {
  const design::DrawnGrid drawn = design::drawn_grid({1000, 100});
  EXPECT_EQ(drawn.columns.size(), 241u);
  EXPECT_EQ(drawn.rows.size(), 100u);
  EXPECT_EQ(drawn.columns.front(), 0);
  EXPECT_EQ(drawn.columns.back(), 999);
  const design::MapGrid nodes = drawn.nodes();
  for (const int k : {0, 1, 100, 239, 240})
    EXPECT_NEAR(drawn.on_map(nodes.place(k, 0)).x, drawn.columns[k] / 999.0, round_off);
}

TEST(MarginLines, LieAtTheirMarginOnAFineGrid) {
  const design::MapGrid grid{700, 500};
  const auto all =
      outcomes(grid, [](int i, int j) { return static_cast<float>(std::exp(0.9 * i / 699 + 0.4 * j / 499)); });
  const auto lines = design::margin_lines(design::drawn_grid(grid), all, std::exp(1.3));
  ASSERT_FALSE(lines.empty());
  for (const design::MarginLine& margin : lines)
    for (const design::MapLine& line : margin.lines)
      for (const design::MapPlace& p : line) EXPECT_NEAR(std::exp(0.9 * p.x + 0.4 * p.y), margin.margin, float_margins);
}

TEST(MarginLines, EndNextToDesignsWithoutBound) {
  const design::MapGrid grid{41, 41};
  const auto all =
      outcomes(grid, [](int i, int j) { return i + j > 50 ? unlimited : static_cast<float>(std::exp(0.05 * i)); });
  const auto lines = design::margin_lines(design::drawn_grid(grid), all, unlimited);
  ASSERT_FALSE(lines.empty());
  for (const design::MarginLine& margin : lines)
    for (const design::MapLine& line : margin.lines)
      for (const design::MapPlace& p : line)
        EXPECT_NEAR(std::exp(2 * p.x), margin.margin, float_margins) << "a step along the border of what has no bound";
}

TEST(MarginLines, EndIfTheyWouldLieCloserThanTheDesigns) {
  const design::MapGrid grid{41, 41};
  const auto all = outcomes(grid, [](int i, int j) {
    return i + j < 30 ? 0.9F : static_cast<float>(1.4 * std::exp(0.02 * i));
  });  // a step from 0.9 to 1.4 … 3.1
  const auto lines = design::margin_lines(design::drawn_grid(grid), all, 3.1);
  ASSERT_FALSE(lines.empty());
  for (const design::MarginLine& margin : lines)
    for (const design::MapLine& line : margin.lines)
      for (const design::MapPlace& p : line)
        EXPECT_NEAR(1.4 * std::exp(0.8 * p.x), margin.margin, float_margins) << "a step along the cliff";
}

TEST(MarginLines, LeadToTheNearestDesignIfNoneIsFeasible) {
  const design::MapGrid grid{201, 101};
  for (const auto& [least, largest] : {std::pair{1e-4, 0.95}, {0.5, 0.9}, {0.037, 0.042}}) {
    const double growth = std::log(largest / least);
    const auto all = outcomes(grid, [&](int i, int) { return static_cast<float>(least * std::exp(growth * i / 200)); });
    const auto lines = design::margin_lines(design::drawn_grid(grid), all, largest);
    EXPECT_GE(lines.size(), 3u) << largest;
    EXPECT_LE(lines.size(), 6u) << largest;
    for (const design::MarginLine& margin : lines)
      for (const design::MapLine& line : margin.lines)
        for (const design::MapPlace& p : line)
          EXPECT_NEAR(least * std::exp(growth * p.x), margin.margin, float_margins * largest);
  }
}

TEST(MarginLines, AreMissingIfNoMarginIsAboveZero) {
  const design::MapGrid grid{5, 5};
  EXPECT_TRUE(design::margin_lines(design::drawn_grid(grid), outcomes(grid, [](int, int) { return 0.0F; }), 0).empty());
}

}  // namespace margin_lines_test
