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

/// ẋ, v̇ and the rate of the hysteretic force.
using Rate = std::function<double(double force, double velocity)>;

struct Marched {
  Vector3d start = Vector3d::Zero();  ///< x, v, hysteretic force at phase 0
  double largest = 0;                 ///< x over the last period
  Matrix3d transition;
};

Vector3d slope(const Rate& rate, double omega, double t, const Vector3d& y) {
  return {y(1), (amplitude * std::cos(omega * t) - damping * y(1) - stiffness * y(0) - y(2)) / mass, rate(y(2), y(1))};
}

Vector3d after_a_period(const Rate& rate, double omega, Vector3d y, double limit, double* largest = nullptr) {
  constexpr int steps = 8'000;
  const double h = 2 * pi / omega / steps;
  for (int i = 0; i < steps; ++i) {
    const double t = i * h;
    const Vector3d k1 = slope(rate, omega, t, y), k2 = slope(rate, omega, t + h / 2, y + h / 2 * k1),
                   k3 = slope(rate, omega, t + h / 2, y + h / 2 * k2), k4 = slope(rate, omega, t + h, y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    y(2) = std::clamp(y(2), -limit, limit);
    if (largest) *largest = std::max(*largest, y(0));
  }
  return y;
}

Marched marched(const Rate& rate, double omega, double limit) {
  Marched found;
  constexpr int periods = 80;
  for (int i = 0; i < periods; ++i) found.start = after_a_period(rate, omega, found.start, limit);
  (void)after_a_period(rate, omega, found.start, limit, &found.largest);
  const Vector3d steps(1e-5 * found.largest, 1e-5 * omega * found.largest, 1e-5 * limit);
  for (int j = 0; j < 3; ++j) {
    const Vector3d change = steps(j) * Vector3d::Unit(j);
    found.transition.col(j) = (after_a_period(rate, omega, found.start + change, limit) -
                               after_a_period(rate, omega, found.start - change, limit)) /
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

void expect_agreement(const elements::HystereticForce& law, const Rate& rate) {
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
    const Marched in_time = marched(rate, point.angular_frequency, elements::force_limit(law));
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
  expect_agreement(law, [law](double force, double velocity) {
    const bool slips = std::abs(force) >= law.slip * (1 - 1e-12) && force * velocity > 0;
    return slips ? 0 : law.stiffness * velocity;
  });
}

TEST(MarchedMotion, BoucWen) {
  const elements::BoucWen law{.stiffness = 2.2e4, .force = 60, .exponent = 1.5, .beta = 0.6, .gamma = 0.3};
  expect_agreement(law, [law](double force, double velocity) {
    const double z = force / law.force, sign = z * velocity > 0 ? 1 : -1;
    return law.stiffness * velocity * (1 - (law.gamma + law.beta * sign) * std::pow(std::abs(z), law.exponent));
  });
}

}  // namespace
