// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "support/projects.h"
#include "trivet/study/influence.h"

namespace {

using namespace trivet;

/// A block on one spring through its centre, pushed along x; the axes are added by each test.
study::Project block(const std::string& x, const std::string& y) {
  return test::project(R"(
trivet = 1
[bodies.block]
mass = 10
inertia = {about = "center_of_mass", xx = 1, yy = 1, zz = 1}
[elements.spring]
type = "bushing"
on = "block"
at = [0, 0, 0]
translation = [900, 1100, 1300]
rotation = [90, 80, 70]
damping = {proportional = 0.05}
[excitations.force]
type = "harmonic"
on = "block"
at = [0, 0, 0.1]
force = [1, 0, 0]
[analyses.map]
no_peak = "coordinates"
x = )" + x + "\ny = " + y + "\n");
}

study::Influence found(const study::Project& project) {
  std::vector<study::MapRule> rules;
  for (const char* name : {"block.x", "block.y", "block.x", "block.ry", "block.rz"}) rules.push_back({response::DesignRule::Kind::no_peak, name, "m", 0.01, ""});
  return study::influence(project.base(), *project.base().analyses.map, rules);
}

const char* const scale = "{parameter = \"elements.spring.scale\", from = 0.5, to = 2}";
const char* const phase = "{parameter = \"excitations.force.phase\", from = 0, to = 3}";

TEST(Influence, NamesTheAnswersThatDoNotMoveOnce) {
  EXPECT_THAT(found(block(scale, "{parameter = \"bodies.block.mass\", from = 5, to = 20}")).still, testing::ElementsAre("block.y", "block.rz"));
}

TEST(Influence, NamesTheAxisThatChangesNothing) {
  const study::Influence of_y = found(block(scale, phase)), of_x = found(block(phase, scale));
  EXPECT_TRUE(of_y.by_x);
  EXPECT_FALSE(of_y.by_y);
  EXPECT_FALSE(of_x.by_x);
  EXPECT_TRUE(of_x.by_y);
}

TEST(Influence, SaysNothingWhereADesignHasNoModel) {
  const study::Influence none = found(block("{parameter = \"bodies.block.mass\", from = -5, to = 20}", phase));
  EXPECT_TRUE(none.still.empty() && none.by_x && none.by_y);
}

}  // namespace
