// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "support/map_outcomes.h"
#include "trivet/design/drawn_grid.h"

namespace best_design_test {

using namespace trivet;
using test::outcomes;
using test::unlimited;

TEST(BestDesign, HasTheLargestMargin) {
  const design::MapGrid grid{4, 3};
  const auto found = design::best_design(
      design::drawn_grid(grid), outcomes(grid, [](int i, int j) { return 2 + 0.1F * float(i) - 0.01F * float(j); }));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->design, grid.index(3, 0));
  EXPECT_EQ(found->without_bound, 0u);
  EXPECT_EQ(found->equals, 1u);
}

TEST(BestDesign, IsInTheMiddleOfEqualDesigns) {
  const design::MapGrid grid{21, 21};  // a plateau that begins at the right frame
  const auto found =
      design::best_design(design::drawn_grid(grid),
                          outcomes(grid, [](int i, int j) { return i >= 12 && j >= 5 && j <= 11 ? 3.0F : 2.0F; }));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->equals, 63u);
  EXPECT_EQ(found->design / 21, 8u);
  EXPECT_EQ(found->without_bound, 0u);
}

TEST(BestDesign, IsInTheMiddleOfAStrip) {
  const design::MapGrid grid{21, 21};
  const auto found =
      design::best_design(design::drawn_grid(grid),
                          outcomes(grid, [](int i, int j) { return i == 20 && j >= 4 && j <= 14 ? 3.0F : 2.0F; }));
  EXPECT_EQ(found->design, grid.index(20, 9));
}

TEST(BestDesign, IsInTheMiddleOfDesignsWithoutBound) {
  const design::MapGrid grid{21, 21};  // not limited: a disc of 5 nodes about (12, 9)
  const auto found = design::best_design(design::drawn_grid(grid), outcomes(grid, [](int i, int j) {
                                           return std::hypot(i - 12, j - 9) < 5.5 ? unlimited : 2.0F;
                                         }));
  EXPECT_EQ(found->design, grid.index(12, 9));
  EXPECT_EQ(found->without_bound, 97u);
}

TEST(BestDesign, IsFarFromTheFrameIfNothingIsLimited) {
  const design::MapGrid grid{11, 21};
  const auto found = design::best_design(design::drawn_grid(grid), outcomes(grid, [](int, int) { return unlimited; }));
  EXPECT_EQ(found->design % 11, 5u);
}

TEST(BestDesign, IsADesignOfAFineGrid) {
  const design::MapGrid grid{1000, 500};
  const auto all = outcomes(
      grid, [](int i, int j) { return std::hypot((i - 700) / 1000.0, (j - 200) / 500.0) < 0.2 ? unlimited : 1.0F; });
  const auto found = design::best_design(design::drawn_grid(grid), all);
  constexpr double column_step = 5, row_step = 3;  // at least every 5th column and every 3rd row is drawn
  EXPECT_NEAR(static_cast<double>(found->design % 1000), 700, column_step);
  EXPECT_NEAR(static_cast<double>(found->design / 1000), 200, row_step);
  EXPECT_TRUE(std::isinf(all[found->design].margin));
}

TEST(BestDesign, IsInTheMiddleIfEveryMarginIsZero) {
  const design::MapGrid grid{11, 11};
  const auto found = design::best_design(design::drawn_grid(grid), outcomes(grid, [](int, int) { return 0.0F; }));
  EXPECT_EQ(found->design, grid.index(5, 5));
  EXPECT_EQ(found->equals, 121u);
}

TEST(BestDesign, DoesNotExistWithoutAnyModel) {
  const design::MapGrid grid{2, 2};
  EXPECT_FALSE(design::best_design(design::drawn_grid(grid),
                                   std::vector<design::DesignOutcome>(4, {0, design::DesignOutcome::no_model})));
}

}  // namespace best_design_test
