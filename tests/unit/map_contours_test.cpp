// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "trivet/design/map_contours.h"

namespace {

using namespace trivet;

// Regions that are known: a disc, its outside, a half, two touching corners.

study::MapContours contours_of(const study::MapGrid& grid, const std::function<double(study::MapPlace)>& level, bool connected = false) {
  const std::function<bool(std::size_t)> inside = [&](std::size_t k) { return level(grid.place(static_cast<int>(k) % grid.nx, static_cast<int>(k) / grid.nx)) >= 0; };
  const auto edges = study::crossed_edges(grid, inside);
  std::vector<double> crossing;
  for (const study::CrossedEdge& e : edges) {
    const double a = level(grid.place(e.i, e.j)), b = level(e.upwards ? grid.place(e.i, e.j + 1) : grid.place(e.i + 1, e.j));
    crossing.push_back(a / (a - b));
  }
  return study::contours(grid, inside, edges, crossing, [&](int, int) { return connected; });
}

TEST(MapContours, GiveTheAreaOfADiscAndOfItsOutside) {
  const auto disc = [](study::MapPlace p) { return 0.3 - std::hypot(p.x - 0.5, p.y - 0.5); };
  const study::MapContours inside = contours_of({201, 201}, disc), outside = contours_of({201, 201}, [&](study::MapPlace p) { return -disc(p); });
  constexpr double chords = 1e-4;  // a polygon of about 240 sides
  EXPECT_NEAR(inside.area, M_PI * 0.09, chords);
  EXPECT_NEAR(outside.area, 1 - M_PI * 0.09, chords);
  ASSERT_EQ(inside.lines.size(), 1u);
  EXPECT_EQ(inside.lines[0].front().x, inside.lines[0].back().x);
  EXPECT_EQ(outside.rings.size(), 2u);  // the frame and the hole
}

TEST(MapContours, EndTheirLinesOnTheFrame) {
  const study::MapContours half = contours_of({11, 11}, [](study::MapPlace p) { return p.x - 0.42; });
  ASSERT_EQ(half.lines.size(), 1u);
  EXPECT_NEAR(half.area, 0.58, 1e-12);
  EXPECT_NEAR(std::abs(half.lines[0].front().y - half.lines[0].back().y), 1, 1e-12);
  for (const study::MapPlace& p : half.lines[0]) EXPECT_NEAR(p.x, 0.42, 1e-12);
}

TEST(MapContours, ConnectOppositeCornersOnlyWhereToldTo) {
  const auto saddle = [](study::MapPlace p) { return (p.x - 0.5) * (p.y - 0.5); };
  EXPECT_EQ(contours_of({2, 2}, saddle, false).rings.size(), 2u);
  EXPECT_EQ(contours_of({2, 2}, saddle, true).rings.size(), 1u);
}

TEST(MapContours, OfEverythingIsTheFrame) {
  const study::MapContours all = contours_of({5, 4}, [](study::MapPlace) { return 1.0; });
  EXPECT_NEAR(all.area, 1, 1e-15);
  EXPECT_TRUE(all.lines.empty());
}

}  // namespace
