// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "support/mapped_machine.h"
#include "support/projects.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/study/map/design_map.h"

namespace unbounded_peaks_test {

using namespace trivet;
using test::mapped_machine;
using test::two_axes;

study::DesignMap mapped(const std::string& text) {
  const project::Project project = test::project(text);
  return study::design_map(project, project.base(), *project.base().analyses.map);
}

void expect_refusal(const std::string& text, const std::string& words) {
  EXPECT_THAT([&] { static_cast<void>(mapped(text)); },
              testing::ThrowsMessage<foundation::NotComputable>(testing::HasSubstr(words)));
}

TEST(UnboundedPeaks, ATiltThatVanishesAtRestAndAtInfinityIsRejected) {
  std::string text = test::mapped_block("{parameter = \"elements.spring.scale\", from = 0.5, to = 2, points = 3}",
                                        "{parameter = \"bodies.block.mass\", from = 5, to = 20, points = 3}");
  EXPECT_EQ(mapped(text).outcomes.size(), 9u);  // the force has a lever about the spring
  text.replace(text.find("at = [0, 0, 0.1]"), 16, "at = [0, 0, 0.0]");
  text.insert(text.find("inertia"), "center_of_mass = [0, 0, 0.1]\n");
  expect_refusal(text, "no_peak: block.ry: a curve that vanishes");
}

TEST(UnboundedPeaks, VelocitiesAreRejectedUnderAForceAndJudgedUnderAnUnbalance) {
  std::string text = mapped_machine("map = {" + two_axes + ", no_peak = \"coordinates\", quantity = \"velocity\"}\n");
  expect_refusal(text, "velocity of machine.z");
  text.replace(text.find("type = \"harmonic\""), 17,
               "type = \"unbalance\"\naxis = \"x\"\nmass_eccentricity = \"1 kg mm\"");
  text.erase(text.find("force = ["), 19);
  EXPECT_GT(mapped(text).feasible_designs, 0u);
}

TEST(UnboundedPeaks, AreAcceptedIfOnlyTheBaseModelHasThem) {
  std::string text = test::mapped_block("{parameter = \"elements.spring.scale\", from = 0.5, to = 2, points = 3}",
                                        "{parameter = \"excitations.second.phase\", from = 1, to = 2, points = 3}");
  text.insert(text.find("inertia"), "center_of_mass = [0, 0, 0.1]\n");
  text.insert(
      text.find("[analyses"),
      "[excitations.second]\ntype = \"harmonic\"\non = \"block\"\nat = [0, 0, -0.1]\nforce = [1, 0, 0]\nphase = 0\n");
  EXPECT_EQ(mapped(text).outcomes.size(), 9u);  // in phase the two forces have no moment about the spring
  text.replace(text.find("from = 1, to = 2"), 16, "from = -1e-17, to = 1e-17");
  expect_refusal(text, "block.ry");
}

}  // namespace unbounded_peaks_test
