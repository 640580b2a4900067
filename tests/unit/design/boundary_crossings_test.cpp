// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "trivet/design/crossings.h"

namespace boundary_crossings_test {

using namespace trivet;

/// Crossings of edges on a row of two designs with the margin as a function of x.
double crossing_of(const std::function<design::DesignOutcome(double)>& design, int* judged = nullptr) {
  const design::JudgePlaces judge = [&](const std::vector<design::MapPlace>& places, const foundation::Progress&) {
    std::vector<design::DesignOutcome> outcomes;
    for (const design::MapPlace& p : places) outcomes.push_back(design(p.x));
    if (judged) *judged += static_cast<int>(places.size());
    return outcomes;
  };
  const design::MapGrid grid{2, 2};
  return design::boundary_crossings(grid, {design(0), design(1), design(0), design(1)}, {{0, 0, false}}, judge).at(0);
}

TEST(BoundaryCrossings, AreFoundWithinToleranceOnASmoothMargin) {
  int judged = 0;
  EXPECT_NEAR(crossing_of([](double x) { return design::DesignOutcome{static_cast<float>(0.5 + x * x), 0}; }, &judged),
              std::sqrt(0.5), design::boundary_tolerance);
  EXPECT_LT(judged, 20);  // fewer than bisection needs
}

TEST(BoundaryCrossings, AreFoundWhereTheMarginJumps) {
  const auto jumps = [](double x) { return design::DesignOutcome{x < 0.3 ? 20.0F : 0.9F, 0}; };
  const auto ends = [](double x) {
    return x < 0.7 ? design::DesignOutcome{1.5F, 0} : design::DesignOutcome{0, design::DesignOutcome::no_model};
  };
  EXPECT_NEAR(crossing_of(jumps), 0.3, design::boundary_tolerance);
  EXPECT_NEAR(crossing_of(ends), 0.7, design::boundary_tolerance);
}

}  // namespace boundary_crossings_test
