// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/projects.h"
#include "trivet/nonlinear/branch/steady_branch.h"

/// Motions that begin where others lose their stability need more harmonics than these.
namespace branched_harmonics_test {

using namespace trivet;
using nonlinear::SteadyBranch;

double largest_of_first_result(const SteadyBranch& curve) {
  double found = 0;
  for (const nonlinear::SteadyPoint& point : curve.points) found = std::max(found, point.results[0].largest);
  return found;
}

/// A mass on a strut under a ceiling that is shaken upright swings at half of its frequency, into a stop beside it: its
/// upright motion is linear.
TEST(BranchedHarmonics, AreRaisedLikeThoseOfTheConnectedCurve) {
  const model::System system = test::project(R"(trivet = 1
gravity = [0, 0, -9.81]
[bodies.m]
mass = 1
free = ["x", "z"]
[elements.strut]
type = "strut"
on = "m"
at = [0, 0, 0]
from_at = [0, 0, 0.5]
free_length = 0.495095
stiffness = 2000
coefficient = 4
[elements.side]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [0, 0, 0]
damping = {translation = [0.2, 0, 0]}
laws.x = {gap_stop = {gap = 0.05, stiffness = 1000}}
[excitations.ceiling]
type = "base"
translation = [0, 0, 0.03]
)")
                                   .base()
                                   .system;
  nonlinear::SteadyOptions options;
  options.of = {"m.x"};
  options.from = 8.2;
  options.to = 9;
  options.harmonics = 0;  // as many as the tolerance needs
  options.tolerance = 1e-3;
  const SteadyBranch found = nonlinear::steady_branch(system, options);
  options.harmonics = 20;
  const SteadyBranch finer = nonlinear::steady_branch(system, options);
  ASSERT_EQ(found.further.size(), 1u);
  ASSERT_EQ(finer.further.size(), 1u);
  EXPECT_EQ(found.further[0].periods, 2);
  EXPECT_LT(found.left_out, 1e-9);  // 5 harmonics are more than enough for the upright motion
  EXPECT_GT(found.further[0].left_out, 1e-5);
  EXPECT_LE(found.further[0].left_out, options.tolerance);
  const double exact = largest_of_first_result(finer.further[0]);
  EXPECT_NEAR(largest_of_first_result(found.further[0]), exact, options.tolerance * exact);
}

}  // namespace branched_harmonics_test
