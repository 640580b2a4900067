// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/static_response.h"

/// Nonlinear parts against linear models of the same machine.
namespace nonlinear_parts_test {

using namespace trivet;
using test::RelativelyNear;

std::string machine(const std::string& more) {
  return R"(trivet = 1
gravity = [0, 0, -9.80665]
[bodies.engine]
mass = 185
inertia = {about = "center_of_mass", xx = 7.2, yy = 11.5, zz = 9.6, xy = 0.7}
points = {exhaust = [-0.25, 0.2, 0.1]}
[element_types.mount]
type = "bushing"
translation = [7e4, 6e4, 2.1e5]
rotation = [200, 300, 400]
damping = {proportional = 4e-3}
[elements]
front = {type = "mount", on = "engine", at = [0.35, 0, -0.15], orientation = {axis = "z", angle = 0.3}}
left = {type = "mount", on = "engine", at = [-0.3, 0.28, -0.15]}
right = {type = "mount", on = "engine", at = [-0.3, -0.28, -0.15]}
[excitations.firing]
type = "harmonic"
on = "engine"
at = [0.1, 0, 0]
moment = [60, 0, 10]
force = [0, 20, 0]
)" + more;
}

constexpr const char* torque = R"([excitations.torque]
type = "constant"
on = "engine"
at = [0, 0, 0]
moment = [-350, 0, 0]
)";

std::vector<double> at_rest(const model::System& system, const std::vector<std::string>& of) {
  const assembly::Assembled assembled = assembly::assemble(system);
  std::vector<double> values;
  for (const response::StaticValue& value : response::static_response(system, assembled, of).values)
    values.push_back(value.value);
  return values;
}

/// A stop that bears at rest is a spring, and a constant force of its stiffness times its gap that pushes into it.
TEST(NonlinearParts, AStopThatBearsIsASpringWithAForce) {
  const double stiffness = 1.5e6, gap = 3e-3;
  const std::string stop = R"([elements.stop]
type = "stop"
on = "engine"
at = [0.05, 0.33, 0]
axis = "-z"
gap = 3e-3
stiffness = 1.5e6
)";
  const std::string spring = R"([elements.stop]
type = "three_springs"
on = "engine"
at = [0.05, 0.33, 0]
translation = [0, 0, 1.5e6]
[excitations.push]
type = "constant"
on = "engine"
at = [0.05, 0.33, 0]
force = [0, 0, -4500]
)";
  ASSERT_EQ(stiffness * gap, 4500);
  const std::vector<std::string> of = {"engine", "engine.exhaust", "left"};
  // A machine with laws is at rest to first order.
  const std::vector<double> bearing = at_rest(test::project(machine(torque + stop)).base().system, of);
  const std::vector<double> linear =
      at_rest(test::project("second_order = false\n" + machine(torque + spring)).base().system, of);
  double largest = 0;
  for (const double value : linear) largest = std::max(largest, std::abs(value));
  for (std::size_t i = 0; i < linear.size(); ++i) EXPECT_NEAR(bearing[i], linear[i], 1e-12 * largest) << i;
}

/// With laws that do nothing, steady motion is the linear response, in motions and forces.
TEST(NonlinearParts, OpenStopsGiveTheLinearResponse) {
  const std::string stop = R"([elements.stop]
type = "stop"
on = "engine"
at = [0.05, 0.33, 0]
axis = "z"
gaps = [1, 1]
stiffness = 1.5e6
)";
  const project::Project with = test::project(machine(stop)), without = test::project(machine(""));
  const std::vector<std::string> of = {"engine", "engine.exhaust", "front", "ground"};
  nonlinear::SteadyOptions options{.from = 20, .to = 60, .harmonics = 3, .of = of};
  options.at = {25, 41.5};
  const nonlinear::SteadyBranch found = nonlinear::steady_branch(with.base().system, options);
  const assembly::Assembled assembled = assembly::assemble(without.base().system);
  const response::FrequencyResponse linear = response::frequency_response(
      assembled, assembly::channels(without.base().system, assembled, of, assembly::MotionQuantity::displacement),
      assembly::harmonic_loading(without.base().system, assembled, {}), options.at);
  ASSERT_EQ(found.at.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    double largest = 0;
    for (const response::Curve& curve : linear.curves) largest = std::max(largest, std::abs(curve.value(i)));
    for (std::size_t c = 0; c < linear.curves.size(); ++c) {
      const std::complex<double> expected = linear.curves[c].value(static_cast<Eigen::Index>(i));
      EXPECT_NEAR(std::abs(found.at[i].results[c].harmonics(0) - expected), 0, 1e-12 * largest) << found.results[c];
      EXPECT_NEAR(found.at[i].results[c].mean, 0, 1e-12 * largest);
    }
  }
}

/// d'Alembert: mass times acceleration is the sum of all forces, at every harmonic and in the mean.
TEST(NonlinearParts, ForcesOnTheGroundBalanceTheMotion) {
  const project::Project project = test::project(machine(R"([elements.stop]
type = "stop"
on = "engine"
at = [0.05, 0.33, 0]
axis = "z"
gaps = [1e-4, 4e-3]
stiffness = 1e5
)"),
                                                 {"elements.left.laws.z={cubic=1e10}"});
  nonlinear::SteadyOptions options{.from = 20, .to = 80, .harmonics = 9, .of = {"engine", "ground"}};
  options.at = {30, 52};
  const nonlinear::SteadyBranch found = nonlinear::steady_branch(project.base().system, options);
  ASSERT_GE(found.at.size(), 2u);
  for (const nonlinear::SteadyPoint& point : found.at)
    for (int axis = 0; axis < 3; ++axis) {
      const nonlinear::ObservedMotion &motion = point.results[static_cast<std::size_t>(axis)],
                                      &force = point.results[static_cast<std::size_t>(6 + axis)];
      EXPECT_NEAR(force.mean, 0, 1e-9);
      for (Eigen::Index k = 0; k < motion.harmonics.size(); ++k) {
        const double omega = point.angular_frequency * static_cast<double>(k + 1);
        const std::complex<double> given = k == 0 && axis == 1 ? 20 : 0;
        EXPECT_NEAR(std::abs(given + 185 * omega * omega * motion.harmonics(k) - force.harmonics(k)), 0, 1e-9) << axis;
      }
    }
}

/// A light part on a nonlinear machine resonates in a band of 0.1 Hz, and hardly bends the branch of the machine.
TEST(NonlinearParts, ResonanceOfALightLinearPartIsNotPassed) {
  const std::string text = R"(trivet = 1
[bodies.m]
mass = 100
free = ["z"]
[bodies.part]
mass = 0.05
free = ["z"]
[elements.s]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [1, 1, 1e5]
damping = {translation = [0, 0, 200]}
laws.z = {cubic = 1e9}
[elements.clip]
type = "three_springs"
on = "part"
from = "m"
at = [0, 0, 0]
translation = [1, 1, 1e3]
damping = {translation = [0, 0, 0.01]}
[excitations.f]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [0, 0, 10]
)";
  const model::System system = test::project(text).base().system;
  constexpr double hertz = 2 * 3.14159265358979323846;
  nonlinear::SteadyOptions options{.from = 1 * hertz, .to = 40 * hertz, .harmonics = 5};
  options.of = {"clip.force.z"};
  const nonlinear::SteadyBranch branch = nonlinear::steady_branch(system, options);
  EXPECT_EQ(branch.ended, "");
  double largest = 0;
  for (const nonlinear::SteadyPoint& point : branch.points) largest = std::max(largest, point.results[0].largest);
  EXPECT_THAT(largest, RelativelyNear(3.693, 3e-3));  // by Runge and Kutta's method in time
}

}  // namespace nonlinear_parts_test
