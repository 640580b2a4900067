// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "support/projects.h"

namespace free_motion_roots_test {

using namespace trivet;

/// Three springs at one point leave three rotations free; a damper resists one combination of them, modal damping
/// none.
constexpr const char* damped_pendulum_without_weight = R"(trivet = 1
[bodies.machine]
mass = 120
center_of_mass = [0.02, -0.01, 0.03]
inertia = {about = "center_of_mass", xx = 3.1, yy = 4.7, zz = 5.3}
[elements.springs]
type = "three_springs"
on = "machine"
at = [0, 0, -0.3]
translation = [2.1e5, 3.3e5, 5.7e5]
[elements.damper]
type = "damper"
on = "machine"
at = [0.11, 0, -0.3]
axis = "y"
coefficient = 230
[damping]
modal = 0.02
[excitations.push]
type = "harmonic"
on = "machine"
at = [0.05, 0, 0.1]
force = [10, 5, 100]
[analyses]
peaks = {}
)";

TEST(FreeMotions, HaveZeroRootsIfADamperDoesNotResistThem) {
  const project::Project project = test::project(damped_pendulum_without_weight);
  project::Analyses request;
  request.roots = true;
  const study::CaseResults results = study::case_results(project.base(), request);
  int at_rest = 0;
  double slowest = std::numeric_limits<double>::infinity();
  for (const modal::Root& root : results.roots.list)
    if (const double size = std::abs(root.eigenvalue); size == 0) ++at_rest;
    else slowest = std::min(slowest, size);
  constexpr double slowest_decay = 1e-3;  // [1/s] c/m with kilograms, far above round-off
  EXPECT_EQ(at_rest, 5);                  // two of each rigid-body mode, one of the mode with the damper
  EXPECT_GT(slowest, slowest_decay);      // the root of the damper
}

TEST(FreeMotions, HaveFinitePeaksWithADamperAndModalDamping) {
  const project::Project project = test::project(damped_pendulum_without_weight);
  const study::CaseResults results = study::case_results(project.base(), project.base().analyses);
  ASSERT_TRUE(results.peaks.has_value());
  EXPECT_GE(results.peaks->peaks.list.size(), 3u);
  for (const response::Peak& peak : results.peaks->peaks.list)
    EXPECT_TRUE(std::isfinite(peak.amplitude) && std::isfinite(peak.angular_frequency));
}

}  // namespace free_motion_roots_test
