// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/nonlinear/modes/backbone.h"
#include "trivet/nonlinear/rest/rest_position.h"

/// Struts that follow finite motion, and a pin within a ring: closed forms.
namespace distance_force_test {

using namespace trivet;
using test::RelativelyNear;

constexpr double pi = std::numbers::pi;

/// Half a kilogram between two tensioned springs of 0.4 m, each fixed at 0.5 m from it, which moves across them.
constexpr const char* between_springs = R"(trivet = 1
[bodies.m]
mass = 0.5
free = ["z"]
[elements.a]
type = "strut"
on = "m"
at = [0, 0, 0]
from_at = [-0.5, 0, 0]
stiffness = "500 N/m"
free_length = "0.4 m"
[elements.b]
type = "strut"
on = "m"
at = [0, 0, 0]
from_at = [0.5, 0, 0]
stiffness = "500 N/m"
free_length = "0.4 m"
)";

TEST(DistanceForce, MassBetweenSpringsStiffensWithItsAmplitude) {
  const model::System system = test::project(between_springs).base().system;
  const struct Row {
    double amplitude, period;
  } rows[] = {
      {0.05, 0.3118449399723219}, {0.1, 0.3053673617481698}, {0.2, 0.28477373727018723}, {0.4, 0.2418306836416642}};
  const auto energy = [](double z) { return 500 * (std::pow(std::hypot(0.5, z) - 0.4, 2) - 0.01); };
  nonlinear::BackboneOptions options{.up_to_energy = 1.01 * energy(0.4), .harmonics = 25};
  options.of = {"m.z"};
  for (const Row& row : rows) options.at_energy.push_back(energy(row.amplitude));
  const nonlinear::Backbone found = nonlinear::backbone(system, options);
  EXPECT_THAT(found.angular_frequency, RelativelyNear(20, 1e-12));  // the geometric stiffness alone
  ASSERT_EQ(found.at_energy.size(), std::size(rows));
  for (std::size_t i = 0; i < std::size(rows); ++i) {
    EXPECT_THAT(found.at_energy[i].results[0].largest, RelativelyNear(rows[i].amplitude, 1e-9));
    EXPECT_THAT(2 * pi / found.at_energy[i].angular_frequency, RelativelyNear(rows[i].period, 1e-9));
  }
}

TEST(DistanceForce, AHangingMassStretchesItsStrut) {
  const project::Project project = test::project(R"(trivet = 1
gravity = [0, 0, -10]
[bodies.m]
mass = 2
free = ["x", "z"]
[elements.rope]
type = "strut"
on = "m"
at = [0, 0, 0]
from_at = [0.3, 0, 0.4]
stiffness = "400 N/m"
[elements.guide]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = ["1 N/m", "0 N/m", "1e-3 N/m"]
)");
  const Eigen::Vector3d moved = project.base().system.elements()[0].distance_parts[0].at_rest;
  // The forces of the strut at its place of rest, and of the guide, carry the weight.
  const Eigen::Vector3d line = Eigen::Vector3d(-0.3, 0, -0.4) + moved;
  const Eigen::Vector3d pull = -400 * (line.norm() - 0.5) * line.normalized();
  EXPECT_NEAR(pull.x() - 1 * moved.x(), 0, 1e-9);
  EXPECT_NEAR(pull.z() - 1e-3 * moved.z(), 20, 1e-9);
  EXPECT_GT(line.norm(), 0.54);
}

/// A pin on springs that are alike in x and y, within a ring about z.
std::string in_ring(const std::string& force, const std::string& stop) {
  return R"(trivet = 1
[bodies.m]
mass = 10
free = ["x", "y"]
[elements.spring]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [2e4, 2e4, 1]
damping = {translation = [60, 60, 0]}
[elements.stop]
type = "stop"
on = "m"
at = [0, 0, 0]
)" + stop +
      R"(stiffness = 1e5
[excitations.F]
type = "harmonic"
on = "m"
at = [0, 0, 0]
)" + force;
}

/// A rotating force moves the pin along a circle: (k + k_s (r − g)/r − m ω² + i c ω) r = F.
TEST(DistanceForce, RotatingForceMovesAPinAlongACircleInItsRing) {
  const project::Project project = test::project(
      in_ring("force = [60, 60, 0]\nphase = [0, -1.5707963267948966, 0, 0, 0, 0]\n", "axis = \"z\"\nring = 1e-3\n"));
  nonlinear::SteadyOptions options{.from = 10, .to = 90, .harmonics = 5, .of = {"m.x", "m.y"}};
  options.at = {30, 50, 60};
  const nonlinear::SteadyBranch branch = nonlinear::steady_branch(project.base().system, options);
  ASSERT_GE(branch.at.size(), 3u);
  for (const nonlinear::SteadyPoint& point : branch.at) {
    const double radius = std::abs(point.results[0].harmonics(0)), omega = point.angular_frequency;
    EXPECT_THAT(std::abs(point.results[1].harmonics(0)), RelativelyNear(radius, 1e-9));
    EXPECT_THAT(point.results[0].largest, RelativelyNear(radius, 1e-9));
    const double contact = radius > 1e-3 ? 1e5 * (radius - 1e-3) / radius : 0;
    const std::complex<double> stiffness(2e4 + contact - 10 * omega * omega, 60 * omega);
    EXPECT_THAT(std::abs(stiffness) * radius, RelativelyNear(60, 1e-8)) << omega;
  }
}

/// Along a line a ring is a stop both ways, in whatever direction.
TEST(DistanceForce, ARingIsAStopBothWaysAlongEveryLine) {
  const auto largest = [](const std::string& force, const std::string& stop, double along_x) {
    const project::Project project = test::project(in_ring(force, stop));
    nonlinear::SteadyOptions options{.from = 10, .to = 90, .harmonics = 15, .of = {"m.x"}};
    options.at = {40};
    const nonlinear::SteadyBranch branch = nonlinear::steady_branch(project.base().system, options);
    return branch.at.at(0).results[0].largest / along_x;
  };
  const double both_ways = largest("force = [60, 0, 0]\n", "axis = \"x\"\ngaps = [1e-3, 1e-3]\n", 1);
  EXPECT_GT(both_ways, 1.2e-3);
  const double ring = largest("force = [60, 0, 0]\n", "axis = \"z\"\nring = 1e-3\n", 1);
  EXPECT_THAT(ring, RelativelyNear(both_ways, 1e-9));
  EXPECT_THAT(largest("force = [36, 48, 0]\n", "axis = \"z\"\nring = 1e-3\n", 0.6), RelativelyNear(ring, 1e-9));
}

/// Both verdicts on stability, with a strut that has a damper and crosses the motion.
TEST(DistanceForce, TwoVerdictsOnStabilityAgree) {
  const project::Project project =
      test::project(in_ring("force = [60, 20, 0]\n", "axis = \"z\"\nring = 1e-3\n") + R"([elements.strut]
type = "strut"
on = "m"
at = [0, 0, 0]
from_at = [0.02, 0.01, 0]
stiffness = "8 kN/m"
coefficient = "20 N s/m"
free_length = "18 mm"
)");
  nonlinear::SteadyOptions options{.from = 30, .to = 60, .harmonics = 4};
  options.deep = true;
  const nonlinear::SteadyBranch branch = nonlinear::steady_branch(project.base().system, options);
  EXPECT_EQ(branch.ended, "");
  EXPECT_EQ(branch.winding.points, std::ssize(branch.points));
  EXPECT_EQ(branch.winding.undecided, 0);
  EXPECT_THAT(branch.winding.differs_at, testing::IsEmpty());
}

/// 1 kg on a strut under a support that shakes by 30 mm: a pendulum of 0.5 m. Upright it loses its stability to swings
/// of twice the period, where the trace of the transition across the strut is −2: by SciPy's DOP853 with 1e-9, and
/// bisection. Undamped, all multipliers are on the unit circle before.
TEST(DistanceForce, UndampedPendulumDoublesItsPeriod) {
  const model::System system = test::project(R"(trivet = 1
gravity = [0, 0, -9.81]
[bodies.m]
mass = 1
free = ["x", "z"]
[elements.s]
type = "strut"
on = "m"
at = [0, 0, 0]
from_at = [0, 0, 0.5]
stiffness = 1e5
free_length = 0.4999
[excitations.f]
type = "base"
translation = [0, 0, 0.03]
)")
                                   .base()
                                   .system;
  nonlinear::SteadyOptions options{.from = 7, .to = 11, .harmonics = 5};
  options.of = {"m.x"};
  const nonlinear::SteadyBranch found = nonlinear::steady_branch(nonlinear::rest_position(system).system, options);
  ASSERT_EQ(found.changes.size(), 2u);
  const double expected[] = {8.377479310274737, 9.453590513141384};
  for (std::size_t i = 0; i < 2; ++i) {
    constexpr double of_place = 1e-6;
    EXPECT_EQ(found.changes[i].kind, nonlinear::StabilityChange::Kind::period_doubling);
    EXPECT_THAT(found.changes[i].point.angular_frequency, RelativelyNear(expected[i], of_place));
  }
}

}  // namespace distance_force_test
