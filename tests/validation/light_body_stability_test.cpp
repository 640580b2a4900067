// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/branch/steady_branch.h"

/// Multipliers beside light bodies and stiff struts, and with nodes without mass.
namespace light_body_stability_test {

using namespace trivet;
using nonlinear::SteadyBranch;
using nonlinear::SteadyPoint;
using test::RelativelyNear;

constexpr double pi = std::numbers::pi;

/// 100 kg on a hardening spring to a part, or to a node without mass, that is on another spring.
struct InSeries {
  double mass = 0;  ///< of the part; 0: a node
  double upper_damping = 0, lower_damping = 0;
  double cubic = 1e10;
  std::string law = "";  ///< another one

  [[nodiscard]] model::System system() const {
    const std::string part =
                          mass > 0 ? fmt::format("[bodies.n]\nmass = {}\n", mass) : "[nodes.n]\nposition = [0, 0, 0]\n",
                      text = fmt::format(R"(trivet = 1
[bodies.m]
mass = 100
free = ["z"]
{}free = ["z"]
[elements.s]
type = "three_springs"
on = "m"
at = [0, 0, 0]
from = "n"
from_at = [0, 0, 0]
translation = [0, 0, 1e5]
damping = {{translation = [0, 0, {}]}}
laws.z = {{{}}}
[elements.g]
type = "three_springs"
on = "n"
at = [0, 0, 0]
translation = [0, 0, 2e5]
damping = {{translation = [0, 0, {}]}}
[elements.d]
type = "damper"
on = "m"
at = [0, 0, 0]
axis = "z"
coefficient = 100
[excitations.f]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [0, 0, 200]
)",
                                         part, upper_damping, law.empty() ? fmt::format("cubic = {}", cubic) : law,
                                         lower_damping);
    return test::project(text).base().system;
  }
};

SteadyBranch branch_of(const model::System& system, std::vector<double> at) {
  nonlinear::SteadyOptions options{.from = 15, .to = 45, .harmonics = 61};
  options.of = {"m.z", "n.z"};
  options.at = std::move(at);
  return nonlinear::steady_branch(system, options);
}

/// ẋ = f(t, x) with its Jacobian, by the classical method of Runge and Kutta.
struct Equations {
  std::function<Eigen::VectorXd(double, const Eigen::VectorXd&)> slope;
  std::function<Eigen::MatrixXd(const Eigen::VectorXd&)> jacobian;
};

struct Returned {
  Eigen::VectorXd start;
  Eigen::MatrixXd transition;
};

/// The motion that returns after a period, by Newton's method with the variational equations.
Returned returned(const Equations& of, double omega, Eigen::VectorXd start) {
  const Eigen::Index n = start.size();
  constexpr int steps = 6000, iterations = 6;
  const double h = 2 * pi / omega / steps;
  Eigen::MatrixXd y(n, n + 1);
  const auto slope = [&](double t, const Eigen::MatrixXd& at) {
    Eigen::MatrixXd found(n, n + 1);
    found.col(0) = of.slope(t, at.col(0));
    found.rightCols(n) = of.jacobian(at.col(0)) * at.rightCols(n);
    return found;
  };
  for (int iteration = 0; iteration < iterations; ++iteration) {
    y << start, Eigen::MatrixXd::Identity(n, n);
    for (int i = 0; i < steps; ++i) {
      const double t = i * h;
      const Eigen::MatrixXd k1 = slope(t, y), k2 = slope(t + h / 2, y + h / 2 * k1),
                            k3 = slope(t + h / 2, y + h / 2 * k2), k4 = slope(t + h, y + h * k3);
      y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    const Eigen::MatrixXd M = y.rightCols(n);
    const Eigen::VectorXd step =
        Eigen::FullPivLU<Eigen::MatrixXd>(Eigen::MatrixXd::Identity(n, n) - M).solve(y.col(0) - start);
    start += step;
    if (step.norm() < 1e-11 * start.norm()) break;
  }
  return {start, y.rightCols(n)};
}

constexpr double lower = 2e5, ground_damper = 100, upper = 1e5, heavy = 100, force = 200;

/// States z_m, z_n, their rates.
Equations with_part(const InSeries& machine, double omega) {
  const double c1 = machine.upper_damping, c2 = machine.lower_damping, k3 = machine.cubic, part = machine.mass;
  return {[=](double t, const Eigen::VectorXd& x) -> Eigen::VectorXd {
            const double d = x(0) - x(1), between = upper * d + c1 * (x(2) - x(3)) + k3 * d * d * d;
            return Eigen::Vector4d(x(2), x(3), (force * std::cos(omega * t) - between - ground_damper * x(2)) / heavy,
                                   (between - lower * x(1) - c2 * x(3)) / part);
          },
          [=](const Eigen::VectorXd& x) -> Eigen::MatrixXd {
            const double d = x(0) - x(1), k = upper + 3 * k3 * d * d;
            Eigen::Matrix4d J;
            J << 0, 0, 1, 0, 0, 0, 0, 1, -k / heavy, k / heavy, -(c1 + ground_damper) / heavy, c1 / heavy, k / part,
                -(k + lower) / part, c1 / part, -(c1 + c2) / part;
            return J;
          }};
}

/// States z_m, its rate, and z_n where a damper holds the node to the ground.
Equations with_node(const InSeries& machine, double omega) {
  const double c = machine.lower_damping, k3 = machine.cubic;
  const auto between = [=](double d) { return upper * d + k3 * d * d * d; };
  if (c > 0)
    return {[=](double t, const Eigen::VectorXd& x) -> Eigen::VectorXd {
              const double pull = between(x(0) - x(2));
              return Eigen::Vector3d(x(1), (force * std::cos(omega * t) - pull - ground_damper * x(1)) / heavy,
                                     (pull - lower * x(2)) / c);
            },
            [=](const Eigen::VectorXd& x) -> Eigen::MatrixXd {
              const double d = x(0) - x(2), k = upper + 3 * k3 * d * d;
              Eigen::Matrix3d J;
              J << 0, 1, 0, -k / heavy, -ground_damper / heavy, k / heavy, k / c, 0, -(k + lower) / c;
              return J;
            }};
  const auto stretch = [=](double z) {  // of the upper spring, by Newton's method
    double d = z / 2;
    for (int i = 0; i < 60; ++i) d -= (between(d) - lower * (z - d)) / (upper + 3 * k3 * d * d + lower);
    return d;
  };
  return {[=](double t, const Eigen::VectorXd& x) -> Eigen::VectorXd {
            return Eigen::Vector2d(
                x(1), (force * std::cos(omega * t) - between(stretch(x(0))) - ground_damper * x(1)) / heavy);
          },
          [=](const Eigen::VectorXd& x) -> Eigen::MatrixXd {
            const double d = stretch(x(0)), k = upper + 3 * k3 * d * d;
            Eigen::Matrix2d J;
            J << 0, 1, -k * lower / (k + lower) / heavy, -ground_damper / heavy;
            return J;
          }};
}

double largest(const Eigen::MatrixXd& transition) {
  return Eigen::EigenSolver<Eigen::MatrixXd>(transition, false).eigenvalues().cwiseAbs().maxCoeff();
}

/// Of the first two results: values and rates at phase 0.
Eigen::Vector4d state_of(const SteadyPoint& point) {
  Eigen::Vector4d state = Eigen::Vector4d::Zero();
  for (Eigen::Index c = 0; c < 2; ++c) {
    const nonlinear::ObservedMotion& motion = point.results[static_cast<std::size_t>(c)];
    state(c) = motion.mean;
    for (Eigen::Index k = 0; k < motion.harmonics.size(); ++k) {
      state(c) += motion.harmonics(k).real();
      state(c + 2) -= static_cast<double>(k + 1) * point.angular_frequency * motion.harmonics(k).imag();
    }
  }
  return state;
}

void expect_oracle(const InSeries& machine, const std::vector<double>& at, std::size_t least_points) {
  const SteadyBranch found = branch_of(machine.system(), at);
  EXPECT_GE(found.at.size(), least_points);
  for (const SteadyPoint& point : found.at) {
    const double omega = point.angular_frequency;
    SCOPED_TRACE(omega);
    const Eigen::Vector4d state = state_of(point);
    const Returned there = machine.mass > 0 ? returned(with_part(machine, omega), omega, state)
        : machine.lower_damping > 0
        ? returned(with_node(machine, omega), omega, Eigen::Vector3d(state(0), state(2), state(1)))
        : returned(with_node(machine, omega), omega, Eigen::Vector2d(state(0), state(2)));
    constexpr double of_motion = 1e-3, of_multiplier = 2e-3;  // what the harmonics leave out
    EXPECT_THAT(state(0), testing::DoubleNear(there.start(0), of_motion * point.results[0].largest));
    EXPECT_NEAR(point.largest_multiplier(), largest(there.transition), of_multiplier);
    EXPECT_TRUE(point.multipliers_hold);
    EXPECT_FALSE(point.uncertain);
    EXPECT_EQ(point.stable, largest(there.transition) < 1);
  }
}

/// The part is on tangents of up to 1e6 N/m: at 39.136 rad/s its quickest oscillation is 26 times as fast as the
/// motion, and steps that do not resolve it gave multipliers of 1e11.
TEST(LightBodyStability, HeavyBodyOnALightPart) {
  expect_oracle({.mass = 1, .upper_damping = 60, .lower_damping = 20}, {20, 33, 36.5, 38, 39.136}, 7);
  expect_oracle({.mass = 0.1, .upper_damping = 60, .lower_damping = 20}, {39.136}, 2);
}

/// Springs in series: a node follows the balance of its forces, with the tangent of each instant.
TEST(LightBodyStability, NodeBetweenTwoSprings) { expect_oracle({}, {20, 36.5, 38.5, 39}, 8); }

TEST(LightBodyStability, NodeWithADamper) { expect_oracle({.lower_damping = 2000}, {20, 36, 37}, 3); }

/// A part of 10 mg with a damper is a node with it, by exponentials in place of splitting.
TEST(LightBodyStability, FeatherIsANode) {
  const std::vector<double> at = {20, 36, 37};
  const SteadyBranch feather = branch_of(InSeries{.mass = 1e-5, .lower_damping = 2000}.system(), at),
                     node = branch_of(InSeries{.lower_damping = 2000}.system(), at);
  ASSERT_EQ(feather.at.size(), node.at.size());
  for (std::size_t i = 0; i < node.at.size(); ++i) {
    constexpr double of_mass = 1e-5;
    EXPECT_NEAR(feather.at[i].largest_multiplier(), node.at[i].largest_multiplier(), of_mass);
    EXPECT_TRUE(feather.at[i].multipliers_hold);
  }
}

/// Liouville: the states lose volume by the dampers alone, whatever the cubic springs do. −tr A⁻¹B of two bodies, of
/// which the light one has down to 1e-3 of the other's mass.
TEST(LightBodyStability, ProductOfMultipliersIsThatOfLiouville) {
  std::mt19937_64 random(51);
  std::uniform_real_distribution<double> share(0, 1);
  constexpr int machines = 8;
  int points = 0;
  for (int i = 0; i < machines; ++i) {
    const double part = 100 * std::pow(10, -3 * share(random)), fastest = std::sqrt(1e6 / part);
    const InSeries machine{.mass = part,
                           .upper_damping = 0.02 * fastest * part * share(random),
                           .lower_damping = 0.02 * fastest * part * share(random),
                           .cubic = std::pow(10, 8 + 2 * share(random))};
    nonlinear::SteadyOptions options{.from = 15, .to = 45, .harmonics = 9};
    const SteadyBranch found = nonlinear::steady_branch(machine.system(), options);
    for (const SteadyPoint& point : found.points) {
      if (!point.multipliers_hold) continue;
      const double trace = (machine.upper_damping + machine.lower_damping) / part +
          (machine.upper_damping + ground_damper) / heavy,
                   product = std::exp(-2 * pi / point.angular_frequency * trace);
      ++points;
      constexpr double of_transition = 1e-4;
      EXPECT_NEAR(std::abs(point.multipliers.prod()), product, of_transition * std::max(product, 1e-3))
          << i << " " << point.angular_frequency;
    }
  }
  EXPECT_GT(points, 200);
}

/// Laws that depend on the rate need a mass or a damper at the node.
TEST(LightBodyStability, WhatANodeCannotDoIsSaidWithAWayOut) {
  const InSeries machine{.law = "gap_stop = {gap = \"1 mm\", stiffness = 1e5, dissipation = 1}"};
  std::string message;
  try {
    (void)branch_of(machine.system(), {});
  } catch (const foundation::NotComputable& error) {
    message = error.what();
  }
  EXPECT_THAT(message, testing::HasSubstr("s.deflection.z depends on its rate and acts on a node, which has no mass"));
  EXPECT_THAT(message, testing::HasSubstr("make the node a body with the mass of the part"));
}

}  // namespace light_body_stability_test
