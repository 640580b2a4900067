// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/branch/stable_motions.h"

#include <gmock/gmock.h>

#include <vector>

namespace stable_motions_test {

using namespace trivet;
using nonlinear::StabilityChange;
using nonlinear::SteadyBranch;
using nonlinear::SteadyPoint;

SteadyPoint point(double omega, bool stable, double largest = 1, double smallest = -1) {
  SteadyPoint found;
  found.angular_frequency = omega;
  found.stable = stable;
  found.results.resize(1);
  found.results[0].largest = largest;
  found.results[0].smallest = smallest;
  return found;
}

/// From 1 to 9 rad/s; motions from 3 to 6 have lost their stability, between 2.5 and 6.5.
SteadyBranch with_lost_stability(StabilityChange::Kind kind) {
  SteadyBranch branch;
  branch.results = {"m.x"};
  for (int omega = 1; omega <= 9; ++omega) branch.points.push_back(point(omega, omega < 3 || omega > 6));
  branch.changes = {{point(2.5, false), 1, kind}, {point(6.5, false), 5, kind}};
  return branch;
}

/// Stable throughout, as far as it goes.
SteadyBranch beside(double from, double to) {
  SteadyBranch curve;
  curve.results = {"m.x"};
  curve.points = {point(from, true), point(to, true)};
  return curve;
}

using Stretches = std::vector<std::pair<double, double>>;

TEST(QuasiPeriodicStretches, ReachFromChangeToChange) {
  using Kind = StabilityChange::Kind;
  SteadyBranch branch = with_lost_stability(Kind::quasi_periodic);
  EXPECT_EQ(nonlinear::without_stable_motion(branch), (Stretches{{2.5, 6.5}}));
  EXPECT_EQ(nonlinear::quasi_periodic_stretches(branch), Stretches()) << "no stable motion at all is known there";
  branch.further = {beside(2, 7)};  // to which a machine need not come
  EXPECT_EQ(nonlinear::without_stable_motion(branch), Stretches());
  EXPECT_EQ(nonlinear::quasi_periodic_stretches(branch), (Stretches{{2.5, 6.5}}));
  branch.changes.pop_back();
  branch.points.resize(6);  // to the end of the band
  EXPECT_EQ(nonlinear::quasi_periodic_stretches(branch), (Stretches{{2.5, 6}}));
  branch = with_lost_stability(Kind::period_doubling);
  branch.further = {beside(2, 7)};
  EXPECT_EQ(nonlinear::quasi_periodic_stretches(branch), Stretches());
}

/// A stop that only pushes: its largest force is 0 everywhere.
TEST(StableExtremes, AreAtTheMotionFarthestFromRest) {
  SteadyBranch branch;
  branch.results = {"stop.force.z"};
  branch.points = {point(1, true, 5e-14, -3), point(2, true, 0, -407), point(3, true, 0, -12),
                   point(4, false, 0, -500)};
  const nonlinear::StableExtremes found = nonlinear::stable_extremes(branch).at(0);
  EXPECT_EQ(found.at->angular_frequency, 2);
  EXPECT_EQ(found.largest, 0) << "round-off";
  EXPECT_EQ(found.smallest, -407);
  EXPECT_EQ(found.farthest_of_all, 500);
}

}  // namespace stable_motions_test
