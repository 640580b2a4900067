// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/nonlinear/branch/steady_branch.h"

/// A stop whose force is a curve of two straight pieces is two stops, the second of which closes at the bend.
namespace curved_stop_test {

using namespace trivet;
using test::RelativelyNear;

study::CaseResults results_of(const std::string& stops) {
  const project::Project project = test::project(R"(trivet = 1
gravity = [0, 0, -9.80665]
[bodies.m]
mass = 40
inertia = {about = "center_of_mass", xx = 1, yy = 1.2, zz = 1.4}
center_of_mass = [0.02, 0.01, 0.1]
[elements.mount]
type = "bushing"
on = "m"
at = [0, 0, 0]
translation = [5e4, 6e4, 4e4]
rotation = [3e3, 3e3, 3e3]
damping = {proportional = 0.003}
[excitations.f]
type = "harmonic"
on = "m"
at = [0.05, 0, 0.1]
force = [10, 0, 150]
[analyses]
static = {of = ["m"]}
steady = {of = ["m.z", "m.ry"], band = ["3 Hz", "12 Hz"], harmonics = 21}
)" + stops);
  return study::case_results(project.base(), project.base().analyses);
}

std::string stop(const std::string& name, const std::string& axis, const std::string& keys) {
  return "[elements." + name + "]\ntype = \"stop\"\non = \"m\"\nat = [0.1, 0.2, 0]\naxis = \"" + axis + "\"\n" + keys +
      "\n";
}

TEST(CurvedStop, IsTwoStops) {
  const std::string rows = "curve = {rows = [[0, 0], [\"2 mm\", \"100 N\"], [\"5 mm\", \"1 kN\"]]}\n";
  const study::CaseResults curved = results_of(stop("up", "z", "gap = \"3 mm\"\n" + rows) +
                                               stop("down", "-z", "gap = \"9 mm\"\ndissipation = 0.8\n" + rows)),
                           two = results_of(
                               stop("up", "z", "gap = \"3 mm\"\nstiffness = 5e4") +
                               stop("up_more", "z", "gap = \"5 mm\"\nstiffness = 2.5e5") +
                               stop("down", "-z", "gap = \"9 mm\"\ndissipation = 0.8\nstiffness = 5e4") +
                               stop("down_more", "-z", "gap = \"11 mm\"\ndissipation = 0.8\nstiffness = 2.5e5"));
  ASSERT_TRUE(curved.failures.empty() && two.failures.empty());
  for (std::size_t i = 0; i < curved.statics->values.size(); ++i)
    EXPECT_NEAR(curved.statics->values[i].value, two.statics->values[i].value, 1e-12);
  const auto &one = *curved.steady, &other = *two.steady;
  constexpr double round_off = 1e-8;  // of folds
  ASSERT_GE(one.folds.size(), 2u) << "it hits the bends";
  ASSERT_EQ(one.folds.size(), other.folds.size());
  for (std::size_t i = 0; i < one.folds.size(); ++i) {
    EXPECT_THAT(one.folds[i].point.angular_frequency,
                RelativelyNear(other.folds[i].point.angular_frequency, round_off));
    EXPECT_THAT(one.folds[i].point.results[0].half_of_range(),
                RelativelyNear(other.folds[i].point.results[0].half_of_range(), 1e-5));
  }
}

}  // namespace curved_stop_test
