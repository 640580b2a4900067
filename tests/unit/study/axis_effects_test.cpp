// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "support/mapped_machine.h"
#include "support/projects.h"
#include "trivet/study/map/map_warnings.h"

namespace axis_effects_test {

using namespace trivet;

study::AxisEffects effects(const project::Project& project) {
  std::vector<design::MapRule> rules;
  for (const char* name : {"block.x", "block.y", "block.x", "block.ry", "block.rz"})
    rules.push_back({design::DesignRule::Kind::no_peak, name, "m", 0.01, ""});
  return study::axis_effects(project.base(), *project.base().analyses.map, rules);
}

const char* const scale = "{parameter = \"elements.spring.scale\", from = 0.5, to = 2}";
const char* const phase = "{parameter = \"excitations.force.phase\", from = 0, to = 3}";

TEST(AxisEffects, NamesEachChannelWithoutMotionOnce) {
  EXPECT_THAT(
      effects(test::project(test::mapped_block(scale, "{parameter = \"bodies.block.mass\", from = 5, to = 20}")))
          .zero_channels,
      testing::ElementsAre("block.y", "block.rz"));
}

TEST(AxisEffects, NamesTheAxisThatChangesNothing) {
  const study::AxisEffects of_y = effects(test::project(test::mapped_block(scale, phase))),
                           of_x = effects(test::project(test::mapped_block(phase, scale)));
  EXPECT_TRUE(of_y.by_x);
  EXPECT_FALSE(of_y.by_y);
  EXPECT_FALSE(of_x.by_x);
  EXPECT_TRUE(of_x.by_y);
}

TEST(AxisEffects, IsEmptyIfADesignHasNoModel) {
  const study::AxisEffects none =
      effects(test::project(test::mapped_block("{parameter = \"bodies.block.mass\", from = -5, to = 20}", phase)));
  EXPECT_TRUE(none.zero_channels.empty() && none.by_x && none.by_y);
}

}  // namespace axis_effects_test
