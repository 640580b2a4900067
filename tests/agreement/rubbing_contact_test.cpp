// SPDX-License-Identifier: BSD-3-Clause
// A casing that rubs on a stop beside it, against marching in time, which shares nothing with the steady motions and
// their multipliers.
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
#include "trivet/nonlinear/modes/backbone.h"
#include "trivet/nonlinear/rest/rest_position.h"

namespace rubbing_contact_test {

using namespace trivet;
using Eigen::Vector2d;
using Eigen::Vector3d;
using State = Eigen::Matrix<double, 8, 1>;  ///< place, velocity, friction along y and z
using Transition = Eigen::Matrix<double, 8, 8>;
using test::RelativelyNear;

constexpr double mass = 25, damping_time = 4e-4, gap_stiffness = 4e5, coefficient = 0.35, sticks_with = 3e5;
const Vector3d stiffness(1.2e5, 0.9e5, 1.4e5);

struct Machine {
  double gap, gravity;  ///< gravity along the stop
  Vector3d push = Vector3d(80, 60, 30);

  [[nodiscard]] std::string project() const {
    return fmt::format(R"(trivet = 1
gravity = [{}, 0, 0]
[bodies.casing]
mass = {}
free = ["x", "y", "z"]
[elements.mount]
type = "three_springs"
on = "casing"
at = [0, 0, 0]
translation = [{}, {}, {}]
damping = {{proportional = {}}}
[elements.stop]
type = "stop"
on = "casing"
at = [0.1, 0, 0]
axis = "x"
gap = {}
stiffness = {}
friction = {{coefficient = {}, stiffness = {}}}
[excitations.push]
type = "harmonic"
on = "casing"
at = [0, 0, 0]
force = [{}, {}, {}]
)",
                       gravity, mass, stiffness(0), stiffness(1), stiffness(2), damping_time, gap, gap_stiffness,
                       coefficient, sticks_with, push(0), push(1), push(2));
  }

  [[nodiscard]] double pressure(double x) const { return std::max(0.0, gap_stiffness * (x - gap)); }
  [[nodiscard]] Vector3d acceleration(double omega, double t, const State& y) const {
    Vector3d force = push * std::cos(omega * t) - stiffness.cwiseProduct(y.head<3>() + damping_time * y.segment<3>(3));
    force.x() += mass * gravity - pressure(y(0));
    force.tail<2>() -= y.tail<2>();
    return force / mass;
  }
  /// Places and velocities by turns; friction beyond its limit is brought back along itself.
  [[nodiscard]] State after_a_period(double omega, State y, Vector3d* largest = nullptr) const {
    constexpr int steps = 10'000;
    const double h = 2 * std::numbers::pi / omega / steps;
    for (int i = 0; i < steps; ++i) {
      const Vector3d before = acceleration(omega, i * h, y), middle = y.segment<3>(3) + h / 2 * before;
      y.head<3>() += h * middle;
      y.tail<2>() += sticks_with * h * middle.tail<2>();
      if (const double limit = coefficient * pressure(y(0)), size = y.tail<2>().norm(); size > limit)
        y.tail<2>() *= limit / size;
      y.segment<3>(3) = middle;
      for (int again = 0; again < 2; ++again)  // as the force depends on the velocity
        y.segment<3>(3) = middle + h / 2 * acceleration(omega, (i + 1) * h, y);
      if (largest) *largest = largest->cwiseMax(y.head<3>());
    }
    return y;
  }
};

struct Marched {
  State start = State::Zero();
  Vector3d largest = Vector3d::Constant(-1);
  Transition transition;
};

Marched marched(const Machine& machine, double omega, double at_rest) {
  Marched found;
  found.start(0) = at_rest;
  constexpr int periods = 20, corrections = 4;  // the rest by Newton's method
  for (int i = 0; i < periods; ++i) found.start = machine.after_a_period(omega, found.start);
  for (int i = 0; i < corrections; ++i) {
    for (int j = 0; j < 8; ++j) {
      State step = State::Zero();
      step(j) = j < 3 ? 1e-8 : j < 6 ? 1e-8 * omega : 1e-3;
      found.transition.col(j) =
          (machine.after_a_period(omega, found.start + step) - machine.after_a_period(omega, found.start - step)) /
          (2 * step(j));
    }
    const State missing = machine.after_a_period(omega, found.start) - found.start;
    found.start += (Transition::Identity() - found.transition).partialPivLu().solve(missing);
  }
  (void)machine.after_a_period(omega, found.start, &found.largest);
  return found;
}

void expect_agreement(const Machine& machine, const std::vector<double>& at) {
  const project::Project given = test::project(machine.project());
  const nonlinear::RestPosition rest = nonlinear::rest_position(given.base().system);
  nonlinear::SteadyOptions options{.from = at.front() - 2, .to = at.back() + 1};
  options.harmonics = 21;
  options.of = {"casing.x", "casing.y", "casing.z"};
  options.at = at;
  const nonlinear::SteadyBranch branch = nonlinear::steady_branch(rest.system, options);
  double at_rest = 0;
  for (const model::Element& element : rest.system.elements())
    for (const model::NonlinearPart& part : element.nonlinear_parts) at_rest = part.at_rest;
  std::size_t compared = 0;
  for (const nonlinear::SteadyPoint& point : branch.at) {
    if (!point.stable) continue;
    SCOPED_TRACE(point.angular_frequency);
    const Marched in_time = marched(machine, point.angular_frequency, at_rest);
    constexpr double of_motion = 1e-3;       // steps of the march where forces turn, 21 harmonics
    constexpr double of_multipliers = 5e-3;  // differences of periods
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_THAT(point.results[i].largest,
                  RelativelyNear(in_time.largest(static_cast<Eigen::Index>(i)) - (i == 0 ? at_rest : 0), of_motion))
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

TEST(RubbingContact, ThatOpensAndCloses) { expect_agreement({3e-4, 0}, {40, 46, 50}); }

TEST(RubbingContact, ThatIsPressedAllTheTime) { expect_agreement({0, 9.81}, {84, 96, 108}); }

/// Driven across the stop alone, the pressure is that of the weight.
TEST(RubbingContact, UnderAWeightAloneIsASlider) {
  const Machine machine{0, 9.81, Vector3d(0, 60, 0)};
  const nonlinear::RestPosition rest = nonlinear::rest_position(test::project(machine.project()).base().system);
  const model::Description rubs = rest.system.description();
  model::Description slides = rubs;
  const double pressure = gap_stiffness * slides.elements[1].nonlinear_parts[0].at_rest;
  slides.elements[1].rubbing_parts.clear();
  slides.elements[0].nonlinear_parts.push_back(
      {1, 0.5, {elements::HystereticForce(elements::Slider{sticks_with, coefficient * pressure})}});
  nonlinear::SteadyOptions options{.from = 30, .to = 130};
  options.of = {"casing.y"};
  options.at = {40, 52, 62, 75, 110};
  const auto points = [&](const model::Description& description) {
    const nonlinear::RestPosition there = nonlinear::rest_position(model::System::checked(description).value());
    return nonlinear::steady_branch(there.system, options).at;
  };
  const auto found = points(rubs), expected = points(slides);
  ASSERT_EQ(found.size(), options.at.size());
  ASSERT_EQ(expected.size(), options.at.size());
  constexpr double of_quadrature = 1e-8;
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_THAT(found[i].results[0].largest, RelativelyNear(expected[i].results[0].largest, of_quadrature));
}

TEST(RubbingContact, TwoVerdictsOnStabilityAgree) {
  for (const Machine& machine : {Machine{3e-4, 0}, Machine{0, 9.81}}) {
    const nonlinear::RestPosition rest = nonlinear::rest_position(test::project(machine.project()).base().system);
    // Beside a fold few harmonics have a multiplier that is not quite 1.
    nonlinear::SteadyOptions options{.from = machine.gravity == 0 ? 40.0 : 84.0,
                                     .to = machine.gravity == 0 ? 43.2 : 94.0};
    options.harmonics = 7;
    options.of = {"casing.y"};
    options.deep = true;
    const nonlinear::SteadyBranch branch = nonlinear::steady_branch(rest.system, options);
    EXPECT_GT(branch.winding.points, 4);
    EXPECT_TRUE(branch.winding.differs_at.empty());
    EXPECT_EQ(branch.winding.undecided, 0);
  }
}

/// A curve from motions that stick to motions that slip in two directions turns at once there; beyond, it is the one
/// that begins there.
TEST(RubbingContact, GoesOnWhereSlipBegins) {
  const nonlinear::RestPosition rest = nonlinear::rest_position(test::project(R"(trivet = 1
[bodies.b]
mass = 10
free = ["x", "y", "z"]
[elements.s]
type = "three_springs"
on = "b"
at = [0, 0, 0]
translation = [4e4, 6e4, 9e4]
damping = {translation = [60, 60, 80]}
[elements.st]
type = "stop"
on = "b"
at = [0, 0, 0]
axis = "x"
gap = 0
stiffness = 2e5
friction = {coefficient = 0.4, stiffness = 1.5e5}
[excitations.e]
type = "harmonic"
on = "b"
at = [0, 0, 0]
force = [60, 120, 150]
phase = ["0 deg", "30 deg", "120 deg", 0, 0, 0]
[excitations.c]
type = "constant"
on = "b"
at = [0, 0, 0]
force = [300, 0, 0]
)")
                                                                    .base()
                                                                    .system);
  const auto curve = [&](double from) {
    nonlinear::SteadyOptions options{.from = from, .to = 1.3};
    options.over = nonlinear::Parameter::load_factor;
    options.angular_frequency = 2 * std::numbers::pi * 9;
    options.harmonics = 8;
    options.of = {"b.y"};
    options.at = {0.96, 1.2};
    return nonlinear::steady_branch(rest.system, options);
  };
  const nonlinear::SteadyBranch whole = curve(0.6), beyond = curve(0.95);
  EXPECT_EQ(whole.ended, "");
  ASSERT_EQ(whole.at.size(), 2u);
  ASSERT_EQ(beyond.at.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_LT((whole.at[i].deflections - beyond.at[i].deflections).norm(), 1e-9 * beyond.at[i].deflections.norm());
}

/// They leave the friction out, whose forces are the last ones.
TEST(RubbingContact, UndampedModesHaveForcesAndAccelerations) {
  const nonlinear::RestPosition rest =
      nonlinear::rest_position(test::project(Machine{0, 9.81}.project()).base().system);
  nonlinear::BackboneOptions options;
  options.mode = 2;  // along the stop
  options.up_to = 1e-3;
  options.of = {"casing.x", "stop.force.x", "ground.force.x"};
  options.quantity = assembly::MotionQuantity::acceleration;
  const nonlinear::Backbone found = nonlinear::backbone(rest.system, options);
  ASSERT_GT(found.points.size(), 3u);
  for (const nonlinear::ObservedMotion& result : found.points.back().results) {
    EXPECT_TRUE(std::isfinite(result.largest));
    EXPECT_GE(result.largest, result.smallest);
  }
}

nonlinear::SteadyPoint only_point(const std::string& text, double at) {
  nonlinear::SteadyOptions options{.from = 38, .to = 51};
  options.harmonics = 11;
  options.of = {"casing.x"};
  options.at = {at};
  return nonlinear::steady_branch(test::project(text).base().system, options).at.at(0);
}

double largest_multiplier(const nonlinear::SteadyPoint& point) {
  double largest = 0;
  for (const std::complex<double>& value : point.multipliers) largest = std::max(largest, std::abs(value));
  return largest;
}

TEST(RubbingContact, OutOfReachLeavesTheMultipliersOfTheOthers) {
  const std::string one = Machine{3e-4, 0}.project();
  const std::string far = one + fmt::format(R"([elements.far]
type = "stop"
on = "casing"
at = [0.1, 0, 0]
axis = "y"
gap = 1
stiffness = 1e5
friction = {{coefficient = 0.3, stiffness = 1e5}}
)");
  const nonlinear::SteadyPoint alone = only_point(one, 46), beside = only_point(far, 46);
  constexpr double of_motion = 1e-7, of_multipliers = 1e-5;
  EXPECT_THAT(beside.results[0].largest, RelativelyNear(alone.results[0].largest, of_motion));
  EXPECT_NEAR(largest_multiplier(beside), largest_multiplier(alone), of_multipliers);
}

/// One stop is two with shares of its stiffnesses, also if one of them closes a little later.
TEST(RubbingContact, MayBeSplit) {
  const Machine machine{3e-4, 0};
  const std::string one = machine.project();
  for (const double later : {0.0, 1e-12}) {
    std::string two = one;
    const auto stop = two.substr(two.find("[elements.stop]"), two.find("[excitations") - two.find("[elements.stop]"));
    const auto share = [&](double of, const char* name, double gap) {
      return fmt::format(
          "[elements.{}]\ntype = \"stop\"\non = \"casing\"\nat = [0.1, 0, 0]\naxis = \"x\"\ngap = {}\nstiffness = {}\n"
          "friction = {{coefficient = {}, stiffness = {}}}\n",
          name, gap, of * gap_stiffness, coefficient, of * sticks_with);
    };
    two.replace(two.find("[elements.stop]"), stop.size(),
                share(0.3, "first", machine.gap) + share(0.7, "second", machine.gap + later));
    const nonlinear::SteadyPoint whole = only_point(one, 46), split = only_point(two, 46);
    constexpr double of_motion = 1e-7, of_multipliers = 1e-5;
    EXPECT_THAT(split.results[0].largest, RelativelyNear(whole.results[0].largest, of_motion)) << later;
    EXPECT_NEAR(largest_multiplier(split), largest_multiplier(whole), of_multipliers) << later;
  }
}

}  // namespace rubbing_contact_test
