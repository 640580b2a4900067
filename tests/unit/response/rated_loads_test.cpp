// SPDX-License-Identifier: BSD-3-Clause
// Static loads of catalogue mounts against equilibrium by hand.
#include "trivet/response/machinery/load_sharing.h"

#include <gmock/gmock.h>

#include <limits>

#include "support/projects.h"

namespace rated_loads_test {

using namespace trivet;

constexpr double round_off = 1e-9;  // of a static solution with stiffnesses that differ by 10

/// A machine on a mount on a frame that is turned on its side: the body frame of `frame` is turned by 90° about x, so
/// that its y is the ground's z.
std::vector<response::RatedLoad> loads_of_two_storeys() {
  const project::Project project = test::project(R"(trivet = 1
gravity = [0, 0, -10]
[bodies.frame]
mass = 30
inertia = {about = "pole", xx = 1, yy = 1, zz = 1}
orientation = {axis = [1, 0, 0], angle = "90 deg"}
free = ["x", "y", "z"]
[bodies.machine]
mass = 20
free = ["x", "y", "z"]
[elements.upper]
type = "catalogue:disc 50x25 55 ShA"
on = "machine"
from = "frame"
at = [0, 0, 0]
axis = [0.6, 0, 0.8]
[elements.lower]
type = "catalogue:disc 75x25 55 ShA"
on = "frame"
at = [0, 0, 0]
axis = "-y"
)");
  return response::rated_loads(project.base().system, assembly::assemble(project.base().system));
}

TEST(RatedLoads, FollowFromEquilibriumInTheAxesOfEachMount) {
  const std::vector<response::RatedLoad> loads = loads_of_two_storeys();
  ASSERT_EQ(loads.size(), 2u);
  const double weight = 200, both = 500;
  EXPECT_NEAR(loads[0].load.z(), 0.8 * weight, round_off * weight);  // e3 leans against the weight
  EXPECT_NEAR(loads[0].load.head<2>().norm(), 0.6 * weight, round_off * weight);
  EXPECT_NEAR(loads[1].load.z(), -both, round_off * both);      // its axis points down: tension
  EXPECT_EQ(loads[1].load.head<2>(), Eigen::Vector2d::Zero());  // no round-off
  EXPECT_LT(loads[0].deflection, 0);
  EXPECT_GT(loads[1].deflection, 0);
}

TEST(RatedLoads, AreWithinARangeUpToNineDigits) {
  const Eigen::Vector2d range(-100, 400);
  EXPECT_TRUE(response::is_within(400 * (1 + 1e-10), range));
  EXPECT_FALSE(response::is_within(400 * (1 + 1e-8), range));
  EXPECT_TRUE(response::is_within(-100 * (1 + 1e-10), range));
  EXPECT_FALSE(response::is_within(-100 * (1 + 1e-8), range));
  EXPECT_FALSE(response::is_within(std::numeric_limits<double>::quiet_NaN(), range));
}

}  // namespace rated_loads_test
