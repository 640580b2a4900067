// SPDX-License-Identifier: BSD-3-Clause
// A pin that rubs around and along the wall of a ring, against marching in time, which shares nothing with the steady
// motions and their multipliers.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/nonlinear/rest/rest_position.h"

namespace rubbing_ring_test {

using namespace trivet;
using Eigen::Vector2d;
using Eigen::Vector3d;
using State = Eigen::Matrix<double, 8, 1>;  ///< place, velocity, stretch of the springs: angle and along the axis
using Transition = Eigen::Matrix<double, 8, 8>;
using test::RelativelyNear;

constexpr double mass = 25, damping_time = 4e-4, play = 8e-4, wall = 4e5, sticks_with = 3e5;
const Vector3d stiffness(1.2e5, 0.9e5, 1.4e5);

struct Machine {
  double gravity;  ///< along x
  Vector3d push;
  Vector3d phases = Vector3d::Zero();  ///< [degrees]
  double coefficient = 0.35;

  [[nodiscard]] std::string project() const {
    return fmt::format(R"(trivet = 1
gravity = [{}, 0, 0]
[bodies.pin]
mass = {}
free = ["x", "y", "z"]
[elements.mount]
type = "three_springs"
on = "pin"
at = [0, 0, 0]
translation = [{}, {}, {}]
damping = {{proportional = {}}}
[elements.ring]
type = "stop"
on = "pin"
at = [0, 0, 0]
axis = "z"
ring = {}
stiffness = {}
friction = {{coefficient = {}, stiffness = {}}}
[excitations.push]
type = "harmonic"
on = "pin"
at = [0, 0, 0]
force = [{}, {}, {}]
phase = ["{} deg", "{} deg", "{} deg", 0, 0, 0]
)",
                       gravity, mass, stiffness(0), stiffness(1), stiffness(2), damping_time, play, wall, coefficient,
                       sticks_with, push(0), push(1), push(2), phases(0), phases(1), phases(2));
  }

  [[nodiscard]] double pressure(const State& y) const { return std::max(0.0, wall * (y.head<2>().norm() - play)); }
  /// Around the ring and along its axis.
  [[nodiscard]] Vector2d friction(const State& y, double radius) const {
    return sticks_with * Vector2d(radius * radius / y.head<2>().norm() * y(6), y(7));
  }
  [[nodiscard]] Vector3d acceleration(double omega, double t, double radius, const State& y) const {
    Vector3d force = -stiffness.cwiseProduct(y.head<3>() + damping_time * y.segment<3>(3));
    for (int i = 0; i < 3; ++i) force(i) += push(i) * std::cos(omega * t + phases(i) * std::numbers::pi / 180);
    force.x() += mass * gravity;
    const double distance = y.head<2>().norm();
    if (distance > play) {
      const Vector2d outwards = y.head<2>() / distance, rubs = friction(y, radius);
      force.head<2>() -= pressure(y) * outwards + rubs.x() * Vector2d(-outwards.y(), outwards.x());
      force.z() -= rubs.y();
    }
    return force / mass;
  }
  /// Places and velocities by turns; friction beyond its limit is brought back along itself.
  [[nodiscard]] State after_a_period(double omega, double radius, State y, Vector3d* largest = nullptr) const {
    constexpr int steps = 10'000;
    const double h = 2 * std::numbers::pi / omega / steps;
    for (int i = 0; i < steps; ++i) {
      const Vector3d before = acceleration(omega, i * h, radius, y), middle = y.segment<3>(3) + h / 2 * before;
      const Vector2d from = y.head<2>();
      y.head<3>() += h * middle;
      const Vector2d to = y.head<2>();
      y(6) += std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
      y(7) += h * middle.z();
      const double limit = coefficient * pressure(y);
      if (const double size = friction(y, radius).norm(); size > limit) y.tail<2>() *= limit / size;
      y.segment<3>(3) = middle;
      for (int again = 0; again < 2; ++again)  // as the force depends on the velocity
        y.segment<3>(3) = middle + h / 2 * acceleration(omega, (i + 1) * h, radius, y);
      if (largest) *largest = largest->cwiseMax(y.head<3>());
    }
    return y;
  }
};

struct Marched {
  Vector3d largest = Vector3d::Constant(-1);
  Transition transition;
};

Marched marched(const Machine& machine, double omega, const Vector3d& at_rest) {
  Marched found;
  State start = State::Zero();
  start.head<3>() = at_rest + Vector3d(1e-9, 0, 0);
  const double radius = std::max(play, at_rest.head<2>().norm());
  constexpr int periods = 40, corrections = 4;  // the rest by Newton's method
  for (int i = 0; i < periods; ++i) start = machine.after_a_period(omega, radius, start);
  for (int i = 0; i < corrections; ++i) {
    for (int j = 0; j < 8; ++j) {
      State step = State::Zero();
      step(j) = j < 3 ? 1e-8 : j < 6 ? 1e-8 * omega : j == 6 ? 1e-5 : 1e-8;
      found.transition.col(j) =
          (machine.after_a_period(omega, radius, start + step) - machine.after_a_period(omega, radius, start - step)) /
          (2 * step(j));
    }
    const State missing = machine.after_a_period(omega, radius, start) - start;
    start += (Transition::Identity() - found.transition).fullPivLu().solve(missing);
  }
  (void)machine.after_a_period(omega, radius, start, &found.largest);
  return found;
}

void expect_agreement(const Machine& machine, const std::vector<double>& at) {
  const nonlinear::RestPosition rest = nonlinear::rest_position(test::project(machine.project()).base().system);
  nonlinear::SteadyOptions options{.from = at.front() - 2, .to = at.back() + 1};
  options.harmonics = 21;
  options.of = {"pin.x", "pin.y", "pin.z"};
  options.at = at;
  const nonlinear::SteadyBranch branch = nonlinear::steady_branch(rest.system, options);
  Vector3d at_rest = Vector3d::Zero();
  for (const model::Element& element : rest.system.elements())
    for (const model::DistancePart& part : element.distance_parts) at_rest = part.at_rest;
  std::size_t compared = 0;
  for (const nonlinear::SteadyPoint& point : branch.at) {
    if (!point.stable) continue;
    SCOPED_TRACE(point.angular_frequency);
    const Marched in_time = marched(machine, point.angular_frequency, at_rest);
    constexpr double of_motion = 1e-3;       // steps of the march where forces turn, 21 harmonics
    constexpr double of_multipliers = 5e-3;  // differences of periods
    for (Eigen::Index i = 0; i < 3; ++i)
      EXPECT_THAT(point.results[static_cast<std::size_t>(i)].largest,
                  RelativelyNear(in_time.largest(i) - at_rest(i), of_motion))
          << i;
    std::vector<double> ours, theirs;
    for (const std::complex<double>& value : point.multipliers) ours.push_back(std::abs(value));
    for (const std::complex<double>& value : Eigen::EigenSolver<Transition>(in_time.transition).eigenvalues())
      theirs.push_back(std::abs(value));
    std::sort(ours.rbegin(), ours.rend());
    std::sort(theirs.rbegin(), theirs.rend());
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(ours[i], theirs[i], of_multipliers) << i;
    ++compared;
  }
  EXPECT_GE(compared, at.size());
}

TEST(RubbingRing, ThatIsHitOnBothSides) { expect_agreement({0, Vector3d(120, 40, 50)}, {45, 53, 54.5}); }

TEST(RubbingRing, ThatIsPressedAllTheTime) {
  expect_agreement({9.81, Vector3d(40, 120, 80), Vector3d(0, 40, 80)}, {84, 96, 108});
}

TEST(RubbingRing, AroundAndAlong) { expect_agreement({0, Vector3d(300, 300, 120), Vector3d(0, -90, 30), 0.04}, {80}); }

TEST(RubbingRing, TwoVerdictsOnStabilityAgree) {
  for (const Machine& machine :
       {Machine{0, Vector3d(120, 40, 50)}, Machine{9.81, Vector3d(40, 120, 80), Vector3d(0, 40, 80)}}) {
    const nonlinear::RestPosition rest = nonlinear::rest_position(test::project(machine.project()).base().system);
    nonlinear::SteadyOptions options{.from = 66, .to = 67};
    options.harmonics = 5;
    options.of = {"pin.y"};
    options.deep = true;
    const nonlinear::SteadyBranch branch = nonlinear::steady_branch(rest.system, options);
    EXPECT_GT(branch.winding.points, 4);
    EXPECT_TRUE(branch.winding.differs_at.empty());
    EXPECT_EQ(branch.winding.undecided, 0);
  }
}

/// Along x and z alone a ring is two stops.
TEST(RubbingRing, ThatIsMetOnTwoSidesIsTwoStops) {
  Machine machine{0, Vector3d(120, 0, 50)};
  const std::string ring = machine.project();
  std::string plane = ring;
  const std::string of_ring = fmt::format("axis = \"z\"\nring = {}", play);
  ASSERT_NE(plane.find(of_ring), std::string::npos);
  plane.replace(plane.find(of_ring), of_ring.size(), fmt::format("axis = \"x\"\ngaps = [{0}, {0}]", play));
  const auto points = [&](const std::string& text) {
    nonlinear::SteadyOptions options{.from = 47, .to = 49};
    options.harmonics = 9;
    options.of = {"pin.x", "pin.z"};
    options.at = {47.5, 48.5};
    return nonlinear::steady_branch(test::project(text).base().system, options).at;
  };
  const auto one = points(ring), other = points(plane);
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i)
    for (std::size_t c = 0; c < 2; ++c)
      EXPECT_THAT(one[i].results[c].largest, RelativelyNear(other[i].results[c].largest, 1e-7));
}

/// With a stop that rubs along the axis of the ring, given before it or after it.
TEST(RubbingRing, BesideAStopIsTheSameInAnyOrder) {
  const std::string ring = Machine{9.81, Vector3d(40, 120, 80), Vector3d(0, 40, 80)}.project(),
                    stop = R"([elements.floor]
type = "stop"
on = "pin"
at = [0, 0, 0]
axis = "z"
gap = 1e-4
stiffness = 2e5
friction = {coefficient = 0.2, stiffness = 1e5}
)";
  std::string before = ring;
  before.insert(before.find("[elements.ring]"), stop);
  const auto point = [](const std::string& text) {
    const nonlinear::RestPosition rest = nonlinear::rest_position(test::project(text).base().system);
    nonlinear::SteadyOptions options{.from = 84, .to = 88};
    options.harmonics = 9;
    options.of = {"pin.x", "pin.y", "pin.z", "ring.force.y", "floor.force.y"};
    options.at = {86};
    options.deep = true;
    const nonlinear::SteadyBranch branch = nonlinear::steady_branch(rest.system, options);
    EXPECT_TRUE(branch.winding.differs_at.empty());
    EXPECT_EQ(branch.winding.undecided, 0);
    return branch.at.at(0);
  };
  const nonlinear::SteadyPoint one = point(before), other = point(ring + stop);
  constexpr double exact = 1e-8;
  for (std::size_t i = 0; i < one.results.size(); ++i)
    EXPECT_THAT(one.results[i].largest, RelativelyNear(other.results[i].largest, exact)) << i;
  EXPECT_GT(one.results[4].largest, 0);
}

}  // namespace rubbing_ring_test
