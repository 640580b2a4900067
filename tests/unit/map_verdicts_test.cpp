// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "support/mapped_machine.h"
#include "support/projects.h"
#include "trivet/study/map_verdicts.h"

namespace {

using namespace trivet;
using test::mapped_machine;
using test::two_axes;

/// ζ = 0.25 at 10 rad/s: the peak stands at 10 √(1 − 2ζ²), the static deflection is 10 mm, and the acceleration tends to F/m = 1 m/s².
TEST(MapVerdicts, TellsWhereACaseGoesBeyondItsLimits) {
  const auto words = [&](const std::vector<std::string>& settings) {
    const study::Project changed = test::project(mapped_machine("map = {" + two_axes + ", limits = {\"machine.z\" = \"15 mm\"}}\n"), settings);
    const study::DesignMap map = study::design_map(changed, changed.base(), *changed.base().analyses.map);
    return study::verdict_words(map, map.marks.at(0)).at(0);
  };
  EXPECT_THAT(words({}), testing::MatchesRegex("machine.z reaches 0.02066 m at 9.354 rad/s, allowed 0.015"));
  EXPECT_THAT(words({"analyses.map.limits={\"machine.z\"=\"5 mm\"}", "analyses.map.band=[0, 1]"}), testing::HasSubstr(" at 1 rad/s, allowed 0.005"));
  EXPECT_THAT(words({"analyses.map.limits={\"machine.z\"=\"0.9 m/s2\"}", "elements.spring.damping.proportional=0.3"}), testing::HasSubstr(" m/s² towards ω = ∞, allowed 0.9"));
}

study::DesignMap nearly_all_kept(std::size_t steep) {
  study::DesignMap map;
  map.outcomes = {{2, 0}, {2, 0}, {2, 0}, {0.99F, 0}};
  map.kept = 3;
  map.feasible.area = 0.999996;
  map.steep = steep;
  return map;
}

TEST(FeasibleWords, DoNotRoundAMapUpThatHasABrokenDesign) {
  study::DesignMap map = nearly_all_kept(0);
  EXPECT_EQ(study::feasible_words(map), "Feasible: less than 100 % of the map, 3 of 4 designs");
  map.kept = 4;
  EXPECT_EQ(study::feasible_words(map), "Feasible: 100.00 % of the map, 4 of 4 designs");
}

TEST(FeasibleWords, TellOfSteepNeighboursAndWhichAreCounted) {
  EXPECT_THAT(study::feasible_words(nearly_all_kept(1)), testing::HasSubstr("; between one pair of neighbours that limits on amplitudes govern the margin changes more than tenfold: "));
  EXPECT_THAT(study::feasible_words(nearly_all_kept(7)), testing::HasSubstr("between 7 pairs of neighbours"));
}

}  // namespace
