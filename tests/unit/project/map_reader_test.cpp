// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/mapped_machine.h"
#include "support/projects.h"

namespace map_reader_test {

using namespace trivet;
using test::mapped_machine;
using test::two_axes;

TEST(MapReader, UsesTheLimitsAndTheQuantityOfTheFileByDefault) {
  const project::Project project =
      test::project(mapped_machine("response = {quantity = \"velocity\", band = [0, 30]}\nmap = {" + two_axes + "}\n",
                                   "[limits]\n\"machine.z\" = \"20 mm/s\"\n"));
  const project::MapRequest& map = *project.base().analyses.map;
  ASSERT_EQ(map.limits.size(), 1u);
  EXPECT_EQ(map.limits[0].name, "machine.z");
  EXPECT_EQ(map.limits[0].quantity, assembly::MotionQuantity::velocity);
  EXPECT_DOUBLE_EQ(map.limits[0].amplitude, 0.02);
  EXPECT_DOUBLE_EQ(map.band->to, 30);
}

TEST(MapReader, DistinguishesDisplacementVelocityAndAccelerationByTheUnit) {
  const project::Project project = test::project(
      mapped_machine("map = {" + two_axes +
                     ", limits = {\"machine.z\" = [\"3 mm\", \"0.2 m/s2\"], \"machine.seat.z\" = \"1 cm/s\"}}\n"));
  const auto& limits = project.base().analyses.map->limits;
  ASSERT_EQ(limits.size(), 3u);
  EXPECT_EQ(limits[0].quantity, assembly::MotionQuantity::displacement);
  EXPECT_EQ(limits[1].quantity, assembly::MotionQuantity::acceleration);
  EXPECT_EQ(limits[2].quantity, assembly::MotionQuantity::velocity);
}

TEST(MapReader, AcceptsAPeakToleranceAboveOne) {
  const project::Project project = test::project(mapped_machine(
      "peaks = {peak_tolerance = 1}\nmap = {" + two_axes + ", no_peak = \"coordinates\", peak_tolerance = 1.5}\n"));
  EXPECT_EQ(project.base().analyses.peaks->peak_tolerance, 1);
  EXPECT_EQ(project.base().analyses.map->peak_tolerance, 1.5);
}

TEST(DesignAxis, ReachesItsEndsExactlyWithBothSpacings) {
  for (const bool logarithmic : {false, true}) {
    const project::DesignAxis axis{"", "", 0.3, 10, "", logarithmic, 101};
    EXPECT_EQ(axis.at(0), 0.3);
    EXPECT_EQ(axis.at(1), 10);
    constexpr double round_off = 1e-14;  // a logarithm and a power, on numbers up to 10
    EXPECT_NEAR(axis.share(axis.at(0.37)), 0.37, round_off);
  }
}

}  // namespace map_reader_test
