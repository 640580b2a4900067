// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/modal/modes.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/nonlinear/rest/rest_position.h"
#include "trivet/response/steady/static_response.h"

/// Machines with nonlinear parts under their weight: closed forms, and full harmonic balance confirmed by shooting.
namespace rest_position_test {

using namespace trivet;
using test::RelativelyNear;

/// 250 kg on a mount that hardens, along x downwards.
std::string on_hardening_mount(double force) {
  return R"(trivet = 1
gravity = [9.80665, 0, 0]
[bodies.m]
mass = 250
free = ["x"]
[elements.mount]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [2e5, 0, 0]
damping = {translation = [1200, 0, 0]}
laws.x = {cubic = "4e9 N/m^3"}
[excitations.F]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [)" +
      std::to_string(force) + ", 0, 0]\n";
}

constexpr double sag = 0.006574578512499824;  // Cardano

TEST(RestPosition, IsTheSagOnAHardeningMountWithItsTangent) {
  const project::Case base = test::project(on_hardening_mount(200)).base();
  const assembly::Assembled assembled = assembly::assemble(base.system);
  const auto rest = response::static_response(base.system, assembled, {"m.x", "mount.force.x"});
  EXPECT_THAT(rest.values[0].value, RelativelyNear(sag, 1e-12));
  EXPECT_THAT(rest.values[1].value, RelativelyNear(250 * 9.80665, 1e-12));
  EXPECT_THAT(assembled.matrices.K(0, 0), RelativelyNear(718700.9914042929, 1e-12));
  EXPECT_THAT(*modal::modes(base.system, assembled).list.front().angular_frequency / (2 * std::numbers::pi),
              RelativelyNear(8.53344216210578, 1e-12));
}

/// A coil spring whose coils touch, and a stop whose gap is measured after the machine has settled.
TEST(RestPosition, CoilsTouchUnderALargeWeight) {
  const auto deflection = [](double mass) {
    const project::Project project =
        test::project("trivet = 1\ngravity = [0, 0, -10]\n[bodies.m]\nmass = " + std::to_string(mass) + R"(
free = ["z"]
[elements.spring]
type = "coil_spring"
on = "m"
at = [0, 0, 0]
wire_diameter = 6e-3
mean_diameter = 50e-3
active_coils = 5
free_length = 0.1
material = "spring_steel"
coil_bind = true
)");
    const model::Element& spring = project.base().system.elements()[0];
    const double stiffness = spring.law.nominal_stiffness(8, 8);
    return std::pair(spring.nonlinear_parts[0].at_rest, stiffness);
  };
  const auto [free, k] = deflection(40);
  constexpr double round_off = 1e-12, travel = 0.07, stiffer = 100;
  EXPECT_THAT(free, RelativelyNear(-400 / k, round_off));
  ASSERT_GT(2000 / k, travel);
  const double beyond = (2000 - k * travel) / (k + stiffer * k);
  EXPECT_THAT(deflection(200).first, RelativelyNear(-travel - beyond, round_off));
}

TEST(RestPosition, AGapMeasuredAtRestIsOpenThere) {
  const std::string stop = R"(
[elements.stop]
type = "stop"
on = "m"
at = [0, 0, 0]
axis = "x"
gap = 1e-3
gap_at = "rest"
stiffness = 1e6
)";
  const project::Project project = test::project(on_hardening_mount(0) + stop);
  const model::NonlinearPart& part = project.base().system.elements()[1].nonlinear_parts[0];
  EXPECT_THAT(part.at_rest, RelativelyNear(sag, 1e-12));
  const auto& gap = std::get<elements::GapStop>(std::get<elements::ElasticForce>(part.laws[0]));
  EXPECT_THAT(gap.upper(), RelativelyNear(sag + 1e-3, 1e-12));
}

TEST(RestPosition, VibrationMovesItsMean) {
  struct Row {
    double force, omega, mean, first, second, smallest, largest;
  };
  for (const Row& row :
       {Row{200, 30, 0.006565598106066, 0.000402768136282, 3.28157208e-05, 0.006191643149778, 0.007000245640801},
        {600, 45, 0.0060114060117, 0.003197825782955, 0.000281057329219, 0.003070037243515, 0.009517693113343},
        {1500, 30, 0.006026130841755, 0.002698451346556, 0.001405459137015, 0.003730961830235, 0.010399532498044}}) {
    const project::Case base = test::project(on_hardening_mount(row.force)).base();
    nonlinear::SteadyOptions options{.from = 3, .to = row.omega + 0.1, .harmonics = 25, .of = {"m.x"}};
    options.at = {row.omega};
    const nonlinear::SteadyBranch found = nonlinear::steady_branch(base.system, options);
    const auto same = [&](const nonlinear::SteadyPoint& point) {
      return std::abs(sag + point.results[0].mean - row.mean) < 1e-8 * row.mean;
    };
    const auto point = std::ranges::find_if(found.at, same);
    ASSERT_NE(point, found.at.end()) << row.force << " N, " << row.omega << " rad/s";
    const nonlinear::ObservedMotion& motion = point->results[0];
    constexpr double digits = 1e-8;
    EXPECT_THAT(std::abs(motion.harmonics(0)), RelativelyNear(row.first, digits));
    EXPECT_THAT(std::abs(motion.harmonics(1)), RelativelyNear(row.second, digits));
    EXPECT_THAT(sag + motion.smallest, RelativelyNear(row.smallest, digits));
    EXPECT_THAT(sag + motion.largest, RelativelyNear(row.largest, digits));
  }
}

/// f = c₁δ + c₂δ² + c₃δ³ with a maximum and a minimum: the load path passes a limit load before it reaches the whole.
TEST(RestPosition, TellsTheLoadAtWhichItSnapsThrough) {
  const std::string text = R"(trivet = 1
gravity = [9.80665, 0, 0]
[bodies.m]
mass = 10
free = ["x"]
[elements.arch]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [100, 0, 0]
laws.x = {polynomial = [3900, -6e5, 2.2e7]}
)";
  const double c1 = 4000, c2 = -6e5, c3 = 2.2e7, weight = 10 * 9.80665;
  const double at = (-2 * c2 - std::sqrt(4 * c2 * c2 - 12 * c1 * c3)) / (6 * c3);
  const double limit = c1 * at + c2 * at * at + c3 * at * at * at;
  ASSERT_LT(limit, weight);
  const model::System system = test::project(text).base().system;
  const nonlinear::RestPosition rest = nonlinear::rest_position(system);
  ASSERT_EQ(rest.limit_loads.size(), 1u);
  EXPECT_THAT(rest.limit_loads[0], RelativelyNear(limit / weight, 1e-9));
  const double there = rest.system.elements()[0].nonlinear_parts[0].at_rest;
  EXPECT_THAT(c1 * there + c2 * there * there + c3 * there * there * there, RelativelyNear(weight, 1e-12));
  EXPECT_GT(there, at);
}

/// A shallow strut, 0.84 mm too long for its place: its force is there before the load, which lifts the plate.
TEST(RestPosition, HasTheLimitLoadOfAStressedStrut) {
  const model::System system = test::project(R"(trivet = 1
gravity = [0, 0, -9.81]
[bodies.plate]
mass = 12
free = ["z"]
[elements.strut]
type = "strut"
on = "plate"
at = [0, 0, 0]
from_at = [-0.2, 0, -0.05]
free_length = 0.207
stiffness = 6e4
[elements.floor]
type = "stop"
on = "plate"
at = [0, 0, 0]
axis = "-z"
gap = 0.08
stiffness = 2e4
)")
                                   .base()
                                   .system;
  const auto bears = [](double down) {
    const double height = 0.05 - down, length = std::hypot(0.2, height);
    return 6e4 * (0.207 - length) * height / length;
  };
  double limit = 0;
  for (double down = -0.01; down < 0.05; down += 1e-6) limit = std::max(limit, bears(down));
  ASSERT_GT(bears(0), 0.1 * limit);
  const nonlinear::RestPosition rest = nonlinear::rest_position(system);
  ASSERT_EQ(rest.limit_loads.size(), 1u);
  EXPECT_THAT(rest.limit_loads[0], RelativelyNear(limit / (12 * 9.81), 1e-8));
}

/// A force that rises to 60 N, falls to 30 N and rises again: the limit load is at a kink.
TEST(RestPosition, HasALimitLoadAtAKink) {
  const model::System system = test::project(R"(trivet = 1
gravity = [9.80665, 0, 0]
[bodies.m]
mass = 10
free = ["x"]
[elements.catch]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [1000, 0, 0]
laws.x = {curve = {rows = [[-1, -5000], [0, 0], [0.01, 50], [0.02, 10], [0.1, 4000]], beyond = "slope"}}
)")
                                   .base()
                                   .system;
  const nonlinear::RestPosition rest = nonlinear::rest_position(system);
  constexpr double at_kinks = 1e-8, weight = 10 * 9.80665;
  ASSERT_EQ(rest.limit_loads.size(), 1u);
  EXPECT_THAT(rest.limit_loads[0], RelativelyNear(60 / weight, at_kinks));
  EXPECT_THAT(rest.system.elements()[0].nonlinear_parts[0].at_rest,
              RelativelyNear(0.02 + (weight - 30) / (1000 + 3990 / 0.08), 1e-10));
}

/// Washers of k z + q z² pass their limit load, and bear less than nothing before a stop: its kink is at a negative
/// load. Beyond it q z² + (k + k_stop) z + k_stop gap + m g = 0.
TEST(RestPosition, IsFoundBeyondNegativeLoads) {
  constexpr double k = 5e4, q = 5e6, stop = 5e5, gap = 0.015, weight = 50 * 9.80665;
  const model::System system = test::project(R"(trivet = 1
gravity = [0, 0, -9.80665]
[bodies.press]
mass = 50
free = ["z"]
[elements.washers]
type = "three_springs"
on = "press"
at = [0, 0, 0]
translation = [0, 0, 5e4]
laws.z = {quadratic = 5e6}
[elements.bump]
type = "stop"
on = "press"
at = [0, 0, 0]
axis = "-z"
gap = 0.015
stiffness = 5e5
)")
                                   .base()
                                   .system;
  const double half = (k + stop) / (2 * q), root = -half + std::sqrt(half * half - (stop * gap + weight) / q);
  EXPECT_THAT(system.elements()[0].nonlinear_parts[0].at_rest, RelativelyNear(root, 1e-12));
  const nonlinear::RestPosition rest = nonlinear::rest_position(system);
  ASSERT_EQ(rest.limit_loads.size(), 1u);
  EXPECT_THAT(rest.limit_loads[0], RelativelyNear(k * k / (4 * q) / weight, 1e-9));
}

/// A buckled support, −8000 x + 2·10⁷ x³, leaves its middle to the side to which its load pushes it.
TEST(RestPosition, LeavesAnUnstableMiddleToTheSideOfItsLoad) {
  for (const double force : {200.0, -200.0}) {
    const model::System system = test::project(R"(trivet = 1
[bodies.sieve]
mass = 20
free = ["x"]
[elements.buckled]
type = "three_springs"
on = "sieve"
at = [0, 0, 0]
translation = [1000, 0, 0]
laws.x = {polynomial = [-9000, 0, 2e7]}
[excitations.chute]
type = "constant"
on = "sieve"
at = [0, 0, 0]
force = [)" + std::to_string(force) + ", 0, 0]\n")
                                     .base()
                                     .system;
    const double x = system.elements()[0].nonlinear_parts[0].at_rest;
    EXPECT_THAT(-8000 * x + 2e7 * x * x * x, RelativelyNear(force, 1e-10));
    EXPECT_GT(x * force, 0);
  }
}

TEST(RestPosition, StatesWithUnknownForcesAreNotListed) {
  const project::Project project = test::project(R"(trivet = 1
gravity = [0, 0, -9.80665]
[bodies.m]
mass = 1
free = ["z"]
[elements.mount]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [0, 0, 1e5]
laws.z = {curve = {rows = [[-0.001, 50], [0, 0], [0.001, -50]], beyond = "refuse"}, cubic = -2e8}
)");
  const std::vector<nonlinear::RestState> states = nonlinear::rest_states(project.base().system);
  ASSERT_EQ(states.size(), 1u);
  EXPECT_LT(std::abs(states[0].deflections.at(0).second), 1e-3);
}

/// A mount that softens, with loads up to one part in ten thousand below its limit load: the stable one of two roots.
TEST(RestPosition, IsTheStableOneJustBelowALimitLoad) {
  const double k = 1e5, softening = 4e8, limit_at = std::sqrt(k / (3 * softening));
  for (const double mass : {50.0, 61.7, 61.8, 61.9, 62.0, 62.03}) {
    const model::System system = test::project(R"(trivet = 1
gravity = [0, 0, -9.81]
[bodies.m]
mass = )" + std::to_string(mass) + R"(
free = ["z"]
[elements.mount]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [0, 0, 1e5]
laws.z = {cubic = -4e8}
)")
                                     .base()
                                     .system;
    double low = 0, high = limit_at;  // the force rises up to there
    for (int i = 0; i < 200; ++i) {
      const double middle = (low + high) / 2;
      (k * middle - softening * middle * middle * middle < mass * 9.81 ? low : high) = middle;
    }
    EXPECT_THAT(-system.elements()[0].nonlinear_parts[0].at_rest, RelativelyNear(low, 1e-10)) << mass;
  }
}

/// A crate that falls through its gap onto a Hertzian stop.
TEST(RestPosition, ClosesAGapThatNothingElseHolds) {
  const model::System system = test::project(R"(trivet = 1
gravity = [0, 0, -9.81]
[bodies.crate]
mass = 120
free = ["z"]
[elements.stop]
type = "stop"
on = "crate"
at = [0, 0, -0.2]
axis = "-z"
gap = "8 mm"
stiffness = 3e8
power = 1.5
)")
                                   .base()
                                   .system;
  const double closed = std::pow(120 * 9.81 / 3e8, 2.0 / 3);
  EXPECT_THAT(system.elements()[0].nonlinear_parts[0].at_rest, RelativelyNear(8e-3 + closed, 1e-12));
}

/// −100 N/m beside 10⁶ N/m³: rest at 0, which is unstable, and at ±10 mm with 2.2508 Hz.
TEST(RestPosition, PostBuckledElementHasThree) {
  const std::string text = R"(trivet = 1
[bodies.m]
mass = 1
free = ["x"]
[elements.strut]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [50, 0, 0]
laws.x = {polynomial = [-150, 0, 1e6]}
)";
  const project::Project project = test::project(text);
  EXPECT_TRUE(std::ranges::any_of(project.base().warnings.list(), [](const auto& problem) {
    return problem.finding == "an unstable position of rest";
  }));
  const std::vector<nonlinear::RestState> states = nonlinear::rest_states(project.base().system);
  ASSERT_EQ(states.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(states[i].stable, i != 1);
    EXPECT_NEAR(states[i].deflections.at(0).second, -0.01 + 0.01 * static_cast<double>(i), 1e-12);
  }
}

/// Two such parts side by side in series of bodies: 3 × 3 positions, of which four are stable.
TEST(RestPosition, IndependentBodiesHaveAllCombinations) {
  const std::string part = R"(
type = "three_springs"
at = [0, 0, 0]
translation = [50, 0, 0]
laws.x = {polynomial = [-150, 0, 1e6]}
)";
  const std::string text =
      "trivet = 1\n[bodies.a]\nmass = 1\nfree = [\"x\"]\n[bodies.b]\nmass = 2\nfree = [\"x\"]\n"
      "[elements.p]\non = \"a\"" +
      part + "[elements.q]\non = \"b\"" + part;
  const std::vector<nonlinear::RestState> states = nonlinear::rest_states(test::project(text).base().system);
  EXPECT_EQ(states.size(), 9u);
  EXPECT_EQ(std::ranges::count_if(states, [](const auto& state) { return state.stable; }), 4);
}

}  // namespace rest_position_test
