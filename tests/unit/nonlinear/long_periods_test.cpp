// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "support/projects.h"
#include "trivet/nonlinear/branch/steady_branch.h"

/// Periods so long that a deviation grows beyond all numbers within one.
namespace long_periods_test {

using namespace trivet;

/// A mass on an unstable place between two wells, −4 N/m and 1 kg: deviations grow as exp(2 t).
TEST(LongPeriods, MotionsThatAreLeftByMoreThanAllNumbersAreNotStable) {
  const model::System system = test::project(R"(trivet = 1
[bodies.m]
mass = 1
free = ["x"]
[elements.s]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [1, 0, 0]
damping = {translation = [0.01, 0, 0]}
laws.x = {polynomial = [-5, 0, 100]}
[excitations.F]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [0.001, 0, 0]
)")
                                   .base()
                                   .system;
  // exp(2 · 2π/ω) is finite up to ω = 4π/710; the steps of a period would be too many from ω = 4π/3700 on.
  for (const double omega : {1e-2, 1e-4, 1e-7, 1e-12}) {
    SCOPED_TRACE(omega);
    const nonlinear::SteadyBranch found =
        nonlinear::steady_branch(system, {.from = omega, .to = 1.01 * omega, .harmonics = 3});
    ASSERT_FALSE(found.points.empty());
    for (const nonlinear::SteadyPoint& point : found.points) {
      EXPECT_NEAR(std::abs(point.deflections(1, 0)), 0.001 / 4, 1e-3 * 0.001 / 4);  // as a static load would move it
      EXPECT_FALSE(point.stable);
    }
  }
}

}  // namespace long_periods_test
