// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <string>

#include "support/projects.h"

/// Keys that a table takes from another one by default, and overrides with any value, also with the usual one.
namespace copied_keys_test {

using namespace trivet;
using assembly::MotionQuantity;

constexpr const char* machine = R"(
trivet = 1
[bodies.box]
mass = 4
free = ["z"]
[elements.spring]
type = "bushing"
on = "box"
at = [0, 0, 0]
translation = [900, 900, 900]
damping = {proportional = 0.05}
[excitations.a]
type = "harmonic"
on = "box"
at = [0, 0, 0]
force = [0, 0, 18]
[excitations.b]
type = "harmonic"
on = "box"
at = [0, 0, 0]
force = [0, 0, 9]
[parameters.scale]
path = "elements.spring.scale"
from = 0.5
to = 2
)";

constexpr const char* response =
    "[analyses]\nresponse = {of = [\"box.z\", \"ground.force.z\"], quantity = \"acceleration\", excitations = [\"a\"], "
    "band = [\"1 Hz\", \"9 Hz\"]}\n";

project::Analyses analyses(const std::string& further) {
  return test::project(std::string(machine) + response + further).base().analyses;
}

TEST(CopiedKeys, AreThoseOfTheResponseWithoutOwnOnes) {
  const auto found = analyses(
      "peaks = {}\noptimize = {minimize = [\"box.z\"]}\n"
      "map = {x = {parameter = \"elements.spring.scale\", from = 0.5, to = 2}, y = {parameter "
      "= \"bodies.box.mass\", from = 1, to = 9}, no_peak = \"coordinates\"}\n"
      "[requirements]\nno_peak = \"coordinates\"\n");
  for (const MotionQuantity quantity :
       {found.peaks->selection.quantity, found.optimize->quantity, found.map->quantity, found.requirements->quantity})
    EXPECT_EQ(quantity, MotionQuantity::acceleration);
  EXPECT_EQ(found.peaks->selection.of, found.response->selection.of);
}

TEST(CopiedKeys, AreOverriddenByTheUsualQuantityToo) {
  const auto found = analyses(
      "peaks = {quantity = \"displacement\", excitations = [\"a\", \"b\"], of = \"coordinates\"}\n"
      "optimize = {minimize = [\"box.z\"], quantity = \"displacement\"}\n"
      "map = {x = {parameter = \"elements.spring.scale\", from = 0.5, to = 2}, y = {parameter = "
      "\"bodies.box.mass\", from = 1, to = 9}, no_peak = \"coordinates\", quantity = \"displacement\", "
      "excitations = [\"b\"]}\n"
      "[requirements]\nno_peak = \"coordinates\"\nquantity = \"displacement\"\nband = [\"2 Hz\", \"8 Hz\"]\n"
      "limits = {\"box.z\" = \"1 mm\"}\nexcitations = [\"a\", \"b\"]\n");
  for (const MotionQuantity quantity :
       {found.peaks->selection.quantity, found.optimize->quantity, found.map->quantity, found.requirements->quantity})
    EXPECT_EQ(quantity, MotionQuantity::displacement);
  EXPECT_THAT(found.peaks->selection.excitations, testing::ElementsAre("a", "b"));
  EXPECT_THAT(found.peaks->selection.of, testing::ElementsAre("coordinates"));
  EXPECT_THAT(found.map->excitations, testing::ElementsAre("b"));
  EXPECT_THAT(found.requirements->excitations, testing::ElementsAre("a", "b"));
}

/// The largest displacement is F/k/(2ζ√(1 − ζ²)) with ζ = 45/(2·60).
TEST(CopiedKeys, GiveThePeaksTheirOwnUnit) {
  const project::Project project =
      test::project(std::string(machine) + response + "peaks = {quantity = \"displacement\"}\n");
  const study::CaseResults results = study::case_results(project.base(), project.base().analyses);
  const response::Peaks& peaks = results.peaks->peaks;
  ASSERT_FALSE(peaks.list.empty());
  constexpr double zeta = 0.375, round_off = 1e-9;
  EXPECT_EQ(peaks.curves[peaks.list.front().curve].unit, "m");
  EXPECT_NEAR(peaks.list.front().amplitude, 18.0 / 900 / (2 * zeta * std::sqrt(1 - zeta * zeta)), round_off);
}

}  // namespace copied_keys_test
