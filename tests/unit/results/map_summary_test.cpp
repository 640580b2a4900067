// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "support/mapped_machine.h"
#include "support/projects.h"
#include "trivet/results/design/map_summary.h"

namespace map_summary_test {

using namespace trivet;
using testing::HasSubstr;

study::DesignMap map_of(const std::string& rules, const std::vector<std::string>& settings = {}) {
  const project::Project project =
      test::project(test::mapped_machine("map = {" + test::two_axes + ", " + rules + "}\n"), settings);
  return study::design_map(project, project.base(), *project.base().analyses.map);
}

study::DesignMap nearly_all_feasible(std::size_t steep) {
  study::DesignMap map;
  map.outcomes = {{2, 0}, {2, 0}, {2, 0}, {0.99F, 0}};
  map.feasible_designs = 3;
  map.feasible.area = 0.999996;
  map.steep = steep;
  return map;
}

TEST(FeasibleWords, DoNotRoundUpAMapWithAnInfeasibleDesign) {
  study::DesignMap map = nearly_all_feasible(0);
  EXPECT_EQ(results::feasible_words(map), "Feasible: less than 100 % of the map, 3 of 4 designs");
  map.feasible_designs = 4;
  EXPECT_EQ(results::feasible_words(map), "Feasible: 100.00 % of the map, 4 of 4 designs");
}

TEST(FeasibleWords, DoNotRoundUpAMapWithAnInfeasibleDesignBetweenFeasibleOnes) {
  study::DesignMap map = nearly_all_feasible(0);
  map.feasible_designs = 4;
  map.band_crossings.pairs = 1;
  EXPECT_EQ(results::feasible_words(map), "Feasible: less than 100 % of the map, 4 of 4 designs");
}

TEST(FeasibleWords, StateHowManySteepNeighboursThereAre) {
  EXPECT_THAT(
      results::feasible_words(nearly_all_feasible(1)),
      testing::HasSubstr(
          "; the margin changes more than tenfold within one pair of neighbouring designs governed by amplitude "
          "limits: "));
  EXPECT_THAT(results::feasible_words(nearly_all_feasible(7)),
              testing::HasSubstr("within 7 pairs of neighbouring designs"));
}

TEST(CriteriaWords, StateTheBandAndWhatCountsAsAPeak) {
  EXPECT_EQ(results::criteria_words(map_of("limits = {\"machine.z\" = \"15 mm\"}, band = [0, 40]")),
            "amplitudes over 0 … 6.3662 Hz");
  EXPECT_EQ(results::criteria_words(map_of("limits = {\"machine.z\" = \"15 mm\"}, band = [\"0 Hz\", \"40 Hz\"]")),
            "amplitudes over 0 … 40 Hz");
  EXPECT_EQ(results::criteria_words(map_of("no_peak = \"machine\", peak_tolerance = 0.02, min_prominence = 1e-4")),
            "resonance peaks at all frequencies, from 2 % above the adjacent minimum (rises below 0.0001 of the curve "
            "maximum are ignored)");
}

/// With amplitude limits alone stiffer is always better, and so is more damping as long as there is a peak.
TEST(BestWords, SayThatABetterDesignMayLieBeyondTheEndOfAnAxis) {
  const study::DesignMap map = map_of("limits = {\"machine.z\" = \"1 mm\"}", {"analyses.map.y.to=0.05"});
  EXPECT_EQ(results::best_ends(map),
            (std::vector<std::string>{"the upper end of stiffness scale of spring",
                                      "the upper end of proportional damping δ of spring"}));
  EXPECT_THAT(results::best_words(map),
              HasSubstr("; at the upper end of stiffness scale of spring and the upper end of proportional damping δ "
                        "of spring, a better one may lie beyond"));
}

/// Far above resonance a soft spring without damping transmits the least force.
TEST(BestWords, DoNotMentionAnEndAtZeroOrWithoutLimits) {
  const study::DesignMap map =
      map_of("limits = {\"spring.force.z\" = \"1 N\"}, band = [200, 300]", {"analyses.map.y.from=0"});
  ASSERT_EQ(map.point(*map.best).y, 0);
  EXPECT_EQ(results::best_ends(map), (std::vector<std::string>{"the lower end of stiffness scale of spring"}));
  EXPECT_TRUE(
      results::best_ends(map_of("no_peak = \"machine\"", {"analyses.map.y.from=1", "analyses.map.y.to=2"})).empty());
}

TEST(BestWords, CallNoDesignNearestIfEveryMarginIsZero) {
  const study::DesignMap map =
      map_of("limits = {\"machine.z\" = \"1 mm\"}, band = [0, 40]",
             {"elements.spring.damping.proportional=0", "analyses.map.y.parameter=\"bodies.machine.mass\"",
              "analyses.map.y.from=8", "analyses.map.y.to=12"});
  EXPECT_EQ(map.outcomes[*map.best].margin, 0);
  EXPECT_THAT(results::best_words(map),
              HasSubstr("No design is feasible and all have margin 0 (machine.z ≤ 1 mm 0-p); the middle one: stiffness "
                        "scale of spring = 1.25, "));
}

TEST(UnlimitedWords, NameAPeakOnlyIfARuleForbidsIt) {
  EXPECT_EQ(
      results::unlimited_words(map_of("limits = {\"machine.z\" = \"1 mm\"}", {"excitations.force.force=[0, 0, 0]"})),
      "no motion");
  EXPECT_EQ(results::unlimited_words(map_of("no_peak = \"machine\"")), "no peak");
}

}  // namespace map_summary_test
