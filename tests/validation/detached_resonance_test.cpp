// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/nonlinear/branch/steady_branch.h"

/// A mass on rubber whose loss is largest at one amplitude: with (A/A_c)² in its law, a force F holds its resonance
/// where A (c ω + 2 L x² / (1 + x⁴)) = F, x = A/A_c. Between the extremes of the left side there are three such
/// amplitudes: a resonance, and a detached curve from the second to the third. It is so narrow that only its resonance
/// leads to it.
namespace detached_resonance_test {

using namespace trivet;
using test::RelativelyNear;

constexpr double mass = 1, stiffness = 400, damping = 0.025, loss = 10, amplitude = 1e-3, force = 10 * amplitude;

double holding_force(double A) {
  const double x = A / amplitude;
  return A * (damping * std::sqrt(stiffness / mass) + 2 * loss * x * x / (1 + x * x * x * x));
}

double amplitude_between(double low, double high) {
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    ((holding_force(low) < force) == (holding_force(middle) < force) ? low : high) = middle;
  }
  return low;
}

TEST(DetachedResonance, IsFoundHoweverNarrow) {
  const project::Project project = test::project(R"(trivet = 1
[bodies.m]
mass = 1
free = ["x"]
[elements.spring]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [400, 0, 0]
damping = {translation = [0.025, 0, 0]}
laws.x = {payne = {stiffness = 0, loss = 10, amplitude = 0.001, exponent = 2}}
[excitations.f]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [0.01, 0, 0]
[analyses.steady]
of = ["m.x"]
band = ["5 rad/s", "60 rad/s"]
harmonics = 1
branches = "all"
)");
  const study::CaseResults results = study::case_results(project.base(), project.base().analyses);
  const auto& branch = *results.steady;
  const auto largest = [](const nonlinear::SteadyBranch& curve) {
    double found = 0;
    for (const nonlinear::SteadyPoint& point : curve.points) found = std::max(found, point.results[0].half_of_range());
    return found;
  };
  const auto smallest = [](const nonlinear::SteadyBranch& curve) {
    double found = INFINITY;
    for (const nonlinear::SteadyPoint& point : curve.points) found = std::min(found, point.results[0].half_of_range());
    return found;
  };
  constexpr double between_points = 0.02;  // the curve is flat at its extremes
  EXPECT_THAT(largest(branch), RelativelyNear(amplitude_between(0.1 * amplitude, 1.3 * amplitude), between_points));
  EXPECT_GE(branch.search->resonances, 1);
  ASSERT_EQ(branch.further.size(), 1u);
  EXPECT_TRUE(branch.further[0].closed);
  EXPECT_THAT(largest(branch.further[0]),
              RelativelyNear(amplitude_between(6 * amplitude, 30 * amplitude), between_points));
  EXPECT_THAT(smallest(branch.further[0]),
              RelativelyNear(amplitude_between(1.4 * amplitude, 5 * amplitude), between_points));
}

}  // namespace detached_resonance_test
