// SPDX-License-Identifier: BSD-3-Clause
// Forces of a stop that is touched briefly, whose harmonics fall slowly, against marching in time.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/nonlinear/branch/steady_branch.h"

namespace force_remainder_test {

using namespace trivet;
using test::RelativelyNear;

constexpr double mass = 10, damping = 80, stiffness = 4e4, push = 15.5, gap = 3e-3, stop = 2e6, dissipation = 0.3;

double force_of_stop(double x, double v) {
  return x > gap ? std::max(0.0, stop * (x - gap) * (1 + dissipation * v)) : 0;
}

struct Marched {
  double x = 0, largest = 0, largest_on_ground = -1, smallest_on_ground = 1, squares = 0, smallest_acceleration = 0;
};

/// By Runge and Kutta's method until it is steady.
Marched marched(double omega) {
  constexpr int periods = 150, steps = 20'000;
  const double h = 2 * std::numbers::pi / omega / steps;
  double x = 0, v = 0;
  Marched found;
  const auto acceleration = [&](double t, double at, double rate) {
    return (push * std::cos(omega * t) - damping * rate - stiffness * at - force_of_stop(at, rate)) / mass;
  };
  for (int p = 0; p < periods; ++p)
    for (int i = 0; i < steps; ++i) {
      const double t = i * h, a1 = acceleration(t, x, v), v2 = v + h / 2 * a1,
                   a2 = acceleration(t + h / 2, x + h / 2 * v, v2), v3 = v + h / 2 * a2,
                   a3 = acceleration(t + h / 2, x + h / 2 * v2, v3), v4 = v + h * a3,
                   a4 = acceleration(t + h, x + h * v3, v4);
      x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
      v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
      if (p + 1 < periods) continue;
      const double force = force_of_stop(x, v), on_ground = force + stiffness * x + damping * v;
      found.x = std::max(found.x, x);
      found.largest = std::max(found.largest, force);
      found.largest_on_ground = std::max(found.largest_on_ground, on_ground);
      found.smallest_on_ground = std::min(found.smallest_on_ground, on_ground);
      found.squares += force * force / steps;
      found.smallest_acceleration = std::min(found.smallest_acceleration, acceleration(t + h, x, v));
    }
  return found;
}

TEST(ForceRemainder, AreThoseOfTheLawsWhereHarmonicsLeaveThemOut) {
  nonlinear::SteadyOptions options;
  options.from = 2 * std::numbers::pi * 9;
  options.to = 2 * std::numbers::pi * 11;
  const double omega = 2 * std::numbers::pi * 10.16;
  options.at = {omega};
  options.harmonics = 40;  // the way into the stop is a hundredth of the deflection
  options.of = {"m.z", "stop.force.z", "ground.force.z"};
  const model::System system = test::project(R"(trivet = 1
[bodies.m]
mass = 10
free = ["z"]
[elements.spring]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [4e4, 4e4, 4e4]
damping = {translation = [0, 0, 80]}
[elements.stop]
type = "stop"
on = "m"
at = [0, 0, 0]
axis = "z"
gap = 3e-3
stiffness = 2e6
dissipation = 0.3
[excitations.push]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [0, 0, 15.5]
)")
                                   .base()
                                   .system;
  const nonlinear::SteadyBranch branch = nonlinear::steady_branch(system, options);
  ASSERT_EQ(branch.at.size(), 1u);
  const std::vector<nonlinear::ObservedMotion>& found = branch.at.front().results;
  const Marched expected = marched(omega);
  ASSERT_GT(expected.largest, 60);
  constexpr double of_deflection = 1e-3, of_force = 1e-2;  // a hundred times that of the deflection, which is 1e-4
  EXPECT_THAT(found[0].largest, RelativelyNear(expected.x, of_deflection));
  EXPECT_THAT(found[1].largest, RelativelyNear(expected.largest, of_force));
  EXPECT_THAT(found[2].largest, RelativelyNear(expected.largest_on_ground, of_force));
  EXPECT_THAT(found[2].smallest, RelativelyNear(expected.smallest_on_ground, of_deflection));
  EXPECT_NEAR(found[1].smallest, 0, 1e-9 * expected.largest);  // a stop does not pull
  options.of = {"m.z"};
  options.quantity = assembly::MotionQuantity::acceleration;
  const nonlinear::SteadyBranch accelerations = nonlinear::steady_branch(system, options);
  EXPECT_THAT(accelerations.at.at(0).results[0].smallest, RelativelyNear(expected.smallest_acceleration, of_force));
  const double about_zero = std::sqrt(found[1].mean * found[1].mean + found[1].rms * found[1].rms);
  EXPECT_THAT(about_zero, RelativelyNear(std::sqrt(expected.squares), of_force));
}

}  // namespace force_remainder_test
