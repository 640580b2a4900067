// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "support/mapped_machine.h"
#include "support/projects.h"
#include "trivet/results/design/map_summary.h"

namespace map_verdicts_test {

using namespace trivet;
using test::mapped_machine;
using test::two_axes;

/// ζ = 0.25 at 10 rad/s: the peak is at 10 √(1 − 2ζ²), the static deflection is 10 mm, and the acceleration tends to
/// F/m = 1 m/s².
TEST(MapVerdicts, StateWhereACaseExceedsItsLimits) {
  const auto words = [&](const std::vector<std::string>& settings) {
    const project::Project changed =
        test::project(mapped_machine("map = {" + two_axes + ", limits = {\"machine.z\" = \"15 mm\"}}\n"), settings);
    const study::DesignMap map = study::design_map(changed, changed.base(), *changed.base().analyses.map);
    return results::verdict_words(map, map.marks.at(0)).at(0);
  };
  EXPECT_THAT(words({}), testing::MatchesRegex("machine.z reaches 20.66 mm 0-p at 1.489 Hz, allowed 15 mm 0-p"));
  EXPECT_THAT(words({"analyses.map.limits={\"machine.z\"=\"5 mm\"}", "analyses.map.band=[0, 1]"}),
              testing::HasSubstr(" at 0.1592 Hz, allowed 5 mm"));
  EXPECT_THAT(words({"analyses.map.limits={\"machine.z\"=\"0.9 m/s2\"}", "elements.spring.damping.proportional=0.3"}),
              testing::HasSubstr(" mm/s² 0-p towards ω = ∞, allowed 900"));
}

TEST(MapVerdicts, CallOnlySmallRisesSlight) {
  const auto words = [&](const std::string& damping) {
    const project::Project changed =
        test::project(mapped_machine("map = {" + two_axes + ", no_peak = \"machine\", peak_tolerance = 0.9}\n"),
                      {"elements.spring.damping.proportional=" + damping});
    const study::DesignMap map = study::design_map(changed, changed.base(), *changed.base().analyses.map);
    return results::verdict_words(map, map.marks.at(0)).at(0);
  };
  EXPECT_THAT(words("0.12"), testing::MatchesRegex("machine.z rises within the tolerance at .* Hz \\(4.17 %\\)"));
  EXPECT_THAT(words("0.06"), testing::MatchesRegex("machine.z has a peak within the tolerance at .* Hz \\(74.7 %\\)"));
}

}  // namespace map_verdicts_test
