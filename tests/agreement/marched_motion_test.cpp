// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/nonlinear/steady_branch.h"

/// Steady motion and its multipliers against marching in time, which shares nothing with them.
namespace {

using namespace trivet;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::RelativelyNear;

constexpr double pi = std::numbers::pi;
constexpr double mass = 12, damping = 60, stiffness = 1.5e4, amplitude = 90;

/// A law in time: the rate of a hysteretic force (one that fades if there is none), and a force without memory.
struct InTime {
  std::function<double(double force, double velocity)> rate = [](double force, double) { return -100 * force; };
  std::function<double(double deflection, double velocity)> force = [](double, double) { return 0; };
};

struct Marched {
  Vector3d start = Vector3d::Zero();  ///< x, v, hysteretic force at phase 0
  double largest = 0;                 ///< x over the last period
  Matrix3d transition;
};

Vector3d slope(const InTime& law, double omega, double t, const Vector3d& y) {
  const double force = y(2) + law.force(y(0), y(1));
  return {y(1), (amplitude * std::cos(omega * t) - damping * y(1) - stiffness * y(0) - force) / mass,
          law.rate(y(2), y(1))};
}

Vector3d after_a_period(const InTime& law, double omega, Vector3d y, double limit, double* largest = nullptr) {
  constexpr int steps = 8'000;
  const double h = 2 * pi / omega / steps;
  for (int i = 0; i < steps; ++i) {
    const double t = i * h;
    const Vector3d k1 = slope(law, omega, t, y), k2 = slope(law, omega, t + h / 2, y + h / 2 * k1),
                   k3 = slope(law, omega, t + h / 2, y + h / 2 * k2), k4 = slope(law, omega, t + h, y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    y(2) = std::clamp(y(2), -limit, limit);
    if (largest) *largest = std::max(*largest, y(0));
  }
  return y;
}

Marched marched(const InTime& law, double omega, double limit) {
  Marched found;
  constexpr int periods = 80;
  for (int i = 0; i < periods; ++i) found.start = after_a_period(law, omega, found.start, limit);
  (void)after_a_period(law, omega, found.start, limit, &found.largest);
  const Vector3d steps(1e-5 * found.largest, 1e-5 * omega * found.largest, 1e-5 * limit);
  for (int j = 0; j < 3; ++j) {
    const Vector3d change = steps(j) * Vector3d::Unit(j);
    found.transition.col(j) = (after_a_period(law, omega, found.start + change, limit) -
                               after_a_period(law, omega, found.start - change, limit)) /
        (2 * steps(j));
  }
  return found;
}

std::vector<double> largest_three(const Eigen::VectorXcd& values) {
  std::vector<double> sizes;
  for (const std::complex<double>& value : values) sizes.push_back(std::abs(value));
  std::sort(sizes.rbegin(), sizes.rend());
  sizes.resize(3, 0.0);
  return sizes;
}

void expect_agreement(const elements::ScalarLaw& law, const InTime& in_law, double limit) {
  const std::string excitation =
      "\n[excitations.F]\ntype = \"harmonic\"\non = \"m1\"\nat = [0, 0, 0]\nforce = [90, 0, 0]\n";
  model::Description description =
      test::project(test::chain({mass}, {stiffness, 0}, {damping, 0}) + excitation).base().system.description();
  description.elements[0].nonlinear_parts = {{0, 0.5, {law}}};
  nonlinear::SteadyOptions options{.from = 20, .to = 70};
  options.harmonics = 31;
  options.of = {"m1.x"};
  options.at = {34, 42, 55};
  const nonlinear::SteadyBranch branch = nonlinear::steady_branch(model::System::checked(description).value(), options);
  ASSERT_EQ(branch.at.size(), options.at.size());
  for (const nonlinear::SteadyPoint& point : branch.at) {
    SCOPED_TRACE(point.angular_frequency);
    const Marched in_time = marched(in_law, point.angular_frequency, limit);
    constexpr double of_motion = 2e-5;       // 31 harmonics; steps of the march across kinks
    constexpr double of_multipliers = 2e-3;  // differences of periods
    EXPECT_THAT(point.results[0].largest, RelativelyNear(in_time.largest, of_motion));
    const std::vector<double> ours = largest_three(point.multipliers),
                              theirs = largest_three(Eigen::EigenSolver<Matrix3d>(in_time.transition).eigenvalues());
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(ours[i], theirs[i], of_multipliers) << i;
    EXPECT_EQ(point.stable, theirs[0] < 1);
  }
}

TEST(MarchedMotion, Slider) {
  const elements::Slider law{2.2e4, 60};
  const auto rate = [law](double force, double velocity) {
    const bool slips = std::abs(force) >= law.slip * (1 - 1e-12) && force * velocity > 0;
    return slips ? 0 : law.stiffness * velocity;
  };
  expect_agreement(elements::HystereticForce(law), {rate}, law.slip);
}

void expect_agreement(const elements::BoucWen& law) {
  const auto rate = [law](double force, double velocity) {
    const double z = force / law.force, of_z = z > 0 ? 1 : -1, of_v = velocity > 0 ? 1 : -1;
    return law.stiffness * velocity *
        (1 -
         (law.gamma + law.beta * of_z * of_v + law.asymmetry * (of_z + of_v)) * std::pow(std::abs(z), law.exponent));
  };
  expect_agreement(elements::HystereticForce(law), {rate}, elements::force_limit(law));
}

TEST(MarchedMotion, BoucWen) {
  expect_agreement({.stiffness = 2.2e4, .force = 60, .exponent = 1.5, .beta = 0.6, .gamma = 0.3});
}

TEST(MarchedMotion, UnsymmetricBoucWen) {
  expect_agreement({.stiffness = 2.2e4, .force = 60, .exponent = 1.5, .beta = 0.6, .gamma = 0.3, .asymmetry = 0.15});
}

/// The force grows with the speed at which the stop closes, and never pulls.
TEST(MarchedMotion, DampedStop) {
  const elements::GapStop stop{.gap_above = 2e-3, .stiffness = 4e4, .dissipation = 1.5};
  const auto force = [stop](double x, double v) {
    return x > stop.gap_above ? stop.stiffness * (x - stop.gap_above) * std::max(0.0, 1 + stop.dissipation * v) : 0;
  };
  expect_agreement(elements::ElasticForce(stop), {.force = force}, 1);
}

}  // namespace
