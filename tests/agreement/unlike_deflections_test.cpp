// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/nonlinear/branch/steady_branch.h"

/// A travel against a stop beside a rotation, which have nothing to do with each other: the travel is the same whatever
/// the size of the rotation, which would hide it if metres and radians had one measure.
namespace unlike_deflections_test {

using namespace trivet;
using test::RelativelyNear;

nonlinear::SteadyBranch beside_a_rotation(double moment, Eigen::Index harmonics) {
  const model::System system = test::project(R"(trivet = 1
[bodies.m]
mass = 10
inertia = {about = "center_of_mass", xx = 1, yy = 1, zz = 0.1}
free = ["x", "rz"]
[elements.s]
type = "bushing"
on = "m"
at = [0, 0, 0]
translation = [1e4, 1e4, 1e4]
rotation = [10, 10, 10]
damping = {proportional = 2e-3}
laws.rz = {cubic = 0.01}
[elements.stop]
type = "stop"
on = "m"
at = [0, 0, 0]
axis = "x"
gap = 2e-4
stiffness = 4e4
[excitations.f]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [3, 0, 0]
moment = [0, 0, )" + std::to_string(moment) + "]\n")
                                   .base()
                                   .system;
  nonlinear::SteadyOptions options{.from = 19, .to = 31};
  options.harmonics = harmonics;
  options.tolerance = 1e-3;
  options.of = {"m.x"};
  return nonlinear::steady_branch(system, options);
}

TEST(UnlikeDeflections, TravelIsTheSameBesideAnyRotation) {
  const nonlinear::SteadyBranch alone = beside_a_rotation(1e-6, 22);
  ASSERT_EQ(alone.folds.size(), 2u);
  for (const double moment : {0.1, 1.0, 20.0}) {
    const nonlinear::SteadyBranch beside = beside_a_rotation(moment, 22);
    EXPECT_EQ(beside.ended, "");
    EXPECT_TRUE(beside.changes.empty()) << moment;
    ASSERT_EQ(beside.folds.size(), 2u) << moment;
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_THAT(beside.folds[i].point.angular_frequency,
                  RelativelyNear(alone.folds[i].point.angular_frequency, 1e-8));
    EXPECT_THAT(beside.left_out, RelativelyNear(alone.left_out, 0.2));
  }
}

TEST(UnlikeDeflections, TravelHasTheSameHarmonicsBesideAnyRotation) {
  const Eigen::Index needed = beside_a_rotation(1e-6, 0).harmonics;
  EXPECT_GT(needed, 9);
  EXPECT_EQ(beside_a_rotation(20, 0).harmonics, needed);
}

}  // namespace unlike_deflections_test
