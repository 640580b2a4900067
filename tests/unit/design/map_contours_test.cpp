// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "trivet/design/map_contours.h"

namespace map_contours_test {

using namespace trivet;

constexpr double round_off = 1e-12;  // a few hundred operations on coordinates from 0 to 1

// Known regions: a disc, its outside, a half, two touching corners.

design::MapContours contours_of(const design::MapGrid& grid, const std::function<double(design::MapPlace)>& level,
                                bool connected = false) {
  const std::function<bool(std::size_t)> inside = [&](std::size_t k) {
    return level(grid.place(static_cast<int>(k) % grid.nx, static_cast<int>(k) / grid.nx)) >= 0;
  };
  const auto edges = design::crossed_edges(grid, inside);
  std::vector<double> crossing;
  for (const design::CrossedEdge& e : edges) {
    const double a = level(grid.place(e.i, e.j)),
                 b = level(e.upwards ? grid.place(e.i, e.j + 1) : grid.place(e.i + 1, e.j));
    crossing.push_back(a / (a - b));
  }
  return design::contours(grid, inside, edges, crossing, [&](int, int) { return connected; });
}

TEST(MapContours, GiveTheAreaOfADiscAndOfItsOutside) {
  const auto disc = [](design::MapPlace p) { return 0.3 - std::hypot(p.x - 0.5, p.y - 0.5); };
  const design::MapContours inside = contours_of({201, 201}, disc),
                            outside = contours_of({201, 201}, [&](design::MapPlace p) { return -disc(p); });
  constexpr double chords = 1e-4;  // a polygon of about 240 sides
  EXPECT_NEAR(inside.area, M_PI * 0.09, chords);
  EXPECT_NEAR(outside.area, 1 - M_PI * 0.09, chords);
  ASSERT_EQ(inside.lines.size(), 1u);
  EXPECT_EQ(inside.lines[0].front().x, inside.lines[0].back().x);
  EXPECT_EQ(outside.rings.size(), 2u);  // the frame and the hole
}

TEST(MapContours, EndTheirLinesOnTheFrame) {
  const design::MapContours half = contours_of({11, 11}, [](design::MapPlace p) { return p.x - 0.42; });
  ASSERT_EQ(half.lines.size(), 1u);
  EXPECT_NEAR(half.area, 0.58, round_off);
  EXPECT_NEAR(std::abs(half.lines[0].front().y - half.lines[0].back().y), 1, round_off);
  for (const design::MapPlace& p : half.lines[0]) EXPECT_NEAR(p.x, 0.42, round_off);
}

TEST(MapContours, ConnectOppositeCornersOnlyOnRequest) {
  const auto saddle = [](design::MapPlace p) { return (p.x - 0.5) * (p.y - 0.5); };
  EXPECT_EQ(contours_of({2, 2}, saddle, false).rings.size(), 2u);
  EXPECT_EQ(contours_of({2, 2}, saddle, true).rings.size(), 1u);
}

TEST(MapContours, AreTheFrameIfEverythingIsInside) {
  const design::MapContours all = contours_of({5, 4}, [](design::MapPlace) { return 1.0; });
  constexpr double few_roundings = 1e-15;  // 14 triangles over the nodes of the frame
  EXPECT_NEAR(all.area, 1, few_roundings);
  EXPECT_TRUE(all.lines.empty());
}

}  // namespace map_contours_test
