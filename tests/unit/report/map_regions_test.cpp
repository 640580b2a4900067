// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/mapped_machine.h"
#include "support/projects.h"
#include "trivet/report/map/map_figure.h"
#include "trivet/report/map/map_regions.h"

namespace map_regions_test {

using namespace trivet;

/// No peak for ζ = δω/2 ≥ 1/√2, on a grid so coarse that the nearest design is often beyond the boundary.
study::DesignMap coarse_map(const std::string& points) {
  const project::Project project =
      test::project(test::mapped_machine("map = {" + test::two_axes + ", no_peak = \"machine\"}\n"),
                    {"analyses.map.x.points=" + points, "analyses.map.y.points=" + points});
  return study::design_map(project, project.base(), *project.base().analyses.map);
}

bool holds(const design::MapLine& ring, const design::MapPlace& p) {
  bool inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const design::MapPlace &a = ring[k], &b = ring[(k + 1) % ring.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

bool holds(const std::vector<design::MapLine>& rings, const design::MapPlace& p) {
  return std::ranges::any_of(rings, [&](const design::MapLine& ring) { return holds(ring, p); });
}

TEST(MapRegions, NoInfeasiblePlaceIsShownAsUnlimited) {
  const study::DesignMap map = coarse_map("9");
  ASSERT_GT(map.without_bound, 10u);
  for (const report::MapRegion& region : report::map_regions(map))
    EXPECT_EQ(region.infeasible.empty(), region.governing == report::MapRegion::unlimited);
}

/// Also on a grid so fine that some designs are not drawn.
TEST(MapRegions, CoverBothSidesOfTheBoundary) {
  for (const char* const points : {"9", "401"}) {
    const study::DesignMap map = coarse_map(points);
    const auto regions = report::map_regions(map);
    for (int k = 0; k < 4000; ++k) {
      const design::MapPlace p{std::fmod(0.31 + 0.618033988749895 * k, 1.0), (k + 0.5) / 4000};
      const bool feasible = holds(map.feasible.rings, p);
      const auto covering = std::ranges::count_if(regions, [&](const report::MapRegion& region) {
        return holds(feasible ? region.feasible : region.infeasible, p);
      });
      EXPECT_EQ(covering, 1) << points << " points: " << p.x << ", " << p.y;
    }
  }
}

TEST(MapFigure, ShowsUnlimitedDesignsLighterInItsKeyToo) {
  const std::string svg = report::map_figure(coarse_map("9"), "").svg;
  const std::size_t words = svg.find("no rule limits it: no peak");
  ASSERT_NE(words, std::string::npos);
  const std::string before = svg.substr(words - 420, 420);
  EXPECT_NE(before.find("width=\"22.00\" height=\"13.00\" fill=\"white\" fill-opacity=\"0.72\""), std::string::npos)
      << before;
}

}  // namespace map_regions_test
