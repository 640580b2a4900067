// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/nonlinear/branch/steady_branch.h"

/// Steady motion and its multipliers against marching in time, which shares nothing with them.
namespace marched_motion_test {

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

using AfterAPeriod = std::function<Vector3d(double omega, const Vector3d& start, double* largest)>;

Marched marched(const AfterAPeriod& after, double omega, double limit) {
  Marched found;
  constexpr int periods = 80;
  for (int i = 0; i < periods; ++i) found.start = after(omega, found.start, nullptr);
  (void)after(omega, found.start, &found.largest);
  const Vector3d steps(1e-5 * found.largest, 1e-5 * omega * found.largest, 1e-5 * limit);
  for (int j = 0; j < 3; ++j) {
    const Vector3d change = steps(j) * Vector3d::Unit(j);
    found.transition.col(j) =
        (after(omega, found.start + change, nullptr) - after(omega, found.start - change, nullptr)) / (2 * steps(j));
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

void expect_agreement(const elements::ScalarLaw& law, const AfterAPeriod& after, double limit, double from = 20) {
  const std::string excitation =
      "\n[excitations.F]\ntype = \"harmonic\"\non = \"m1\"\nat = [0, 0, 0]\nforce = [90, 0, 0]\n";
  model::Description description =
      test::project(test::chain({mass}, {stiffness, 0}, {damping, 0}) + excitation).base().system.description();
  description.elements[0].nonlinear_parts = {{0, 0.5, {law}}};
  nonlinear::SteadyOptions options{.from = from, .to = 70};
  options.harmonics = 31;
  options.of = {"m1.x"};
  options.at = {34, 42, 55};
  const nonlinear::SteadyBranch branch = nonlinear::steady_branch(model::System::checked(description).value(), options);
  ASSERT_EQ(branch.at.size(), options.at.size());
  for (const nonlinear::SteadyPoint& point : branch.at) {
    SCOPED_TRACE(point.angular_frequency);
    const Marched in_time = marched(after, point.angular_frequency, limit);
    constexpr double of_motion = 2e-5;       // 31 harmonics; steps of the march across kinks
    constexpr double of_multipliers = 2e-3;  // differences of periods
    EXPECT_THAT(point.results[0].largest, RelativelyNear(in_time.largest, of_motion));
    const std::vector<double> ours = largest_three(point.multipliers),
                              theirs = largest_three(Eigen::EigenSolver<Matrix3d>(in_time.transition).eigenvalues());
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(ours[i], theirs[i], of_multipliers) << i;
    EXPECT_EQ(point.stable, theirs[0] < 1);
  }
}

void expect_agreement(const elements::ScalarLaw& law, const InTime& in_law, double limit) {
  expect_agreement(
      law,
      [&](double omega, const Vector3d& start, double* largest) {
        return after_a_period(in_law, omega, start, limit, largest);
      },
      limit);
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

TEST(MarchedMotion, DampedStopWithACurve) {
  const elements::GapStop stop{
      .gap_above = 2e-3,
      .dissipation = 1.5,
      .curve = elements::KnotCurve({0, 1e-3, 3e-3}, {0, 20, 120}, elements::Interpolation::linear)};
  const auto force = [](double x, double v) {
    const double travel = x - 2e-3, pushed = travel < 1e-3 ? 2e4 * travel : 20 + 5e4 * (travel - 1e-3);
    return travel > 0 ? pushed * std::max(0.0, 1 + 1.5 * v) : 0;
  };
  expect_agreement(elements::ElasticForce(stop), {.force = force}, 1);
}

/// Bristles with a Stribeck curve and their dampers; the third number is the force of their deflection alone.
TEST(MarchedMotion, LuGre) {
  const elements::LuGreFriction law{
      .stiffness = 2e5, .slip = 40, .breakaway = 55, .stribeck_velocity = 0.06, .damping = 90, .viscous = 40};
  const auto slope = [law](double omega, double t, const Vector3d& y) {
    const double ratio = y(1) / law.stribeck_velocity,
                 steady = law.slip + (law.breakaway - law.slip) * std::exp(-ratio * ratio),
                 bristle_rate = y(1) - std::abs(y(1)) * y(2) / steady,
                 force = y(2) + law.damping * bristle_rate + law.viscous * y(1);
    return Vector3d(y(1), (amplitude * std::cos(omega * t) - damping * y(1) - stiffness * y(0) - force) / mass,
                    law.stiffness * bristle_rate);
  };
  const auto after = [slope](double omega, const Vector3d& start, double* largest) {
    constexpr int steps = 16'000;
    const double h = 2 * pi / omega / steps;
    Vector3d y = start;
    for (int i = 0; i < steps; ++i) {
      const double t = i * h;
      const Vector3d k1 = slope(omega, t, y), k2 = slope(omega, t + h / 2, y + h / 2 * k1),
                     k3 = slope(omega, t + h / 2, y + h / 2 * k2), k4 = slope(omega, t + h, y + h * k3);
      y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      if (largest) *largest = std::max(*largest, y(0));
    }
    return y;
  };
  expect_agreement(law, after, law.breakaway);
}

/// Sticks with its stiffness, or slips with one force. The instants of change are found by bisection.
struct BreakingAway {
  elements::Slider law;
  double sense = 0;  ///< of slip; 0: it sticks

  /// x, v, and its force after a time.
  [[nodiscard]] Vector3d after(double omega, double t, const Vector3d& y, double h) const {
    const auto slope = [&](double at, const Vector3d& z) {
      return Vector3d(z(1), (amplitude * std::cos(omega * at) - damping * z(1) - stiffness * z(0) - z(2)) / mass,
                      sense == 0 ? law.stiffness * z(1) : 0);
    };
    const Vector3d k1 = slope(t, y), k2 = slope(t + h / 2, y + h / 2 * k1), k3 = slope(t + h / 2, y + h / 2 * k2),
                   k4 = slope(t + h, y + h * k3);
    return y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  [[nodiscard]] bool changes(const Vector3d& y) const {
    return sense == 0 ? std::abs(y(2)) > law.limit() : sense * y(1) < 0;
  }
  Vector3d after_a_period(double omega, Vector3d y, double* largest) {
    constexpr int steps = 4'000;
    const double h = 2 * pi / omega / steps;
    sense = std::abs(std::abs(y(2)) - law.slip) < 1e-9 && y(2) * y(1) > 0 ? (y(1) > 0 ? 1 : -1) : 0;
    for (int i = 0; i < steps; ++i) {
      double t = i * h, left = h;
      while (changes(after(omega, t, y, left))) {
        double low = 0, high = left;
        for (int b = 0; b < 60; ++b) (changes(after(omega, t, y, (low + high) / 2)) ? high : low) = (low + high) / 2;
        y = after(omega, t, y, high);
        t += high;
        left -= high;
        sense = sense != 0 ? 0 : (y(1) > 0 ? 1 : -1);
        if (sense != 0) y(2) = sense * law.slip;
      }
      y = after(omega, t, y, left);
      if (largest) *largest = std::max(*largest, y(0));
    }
    return y;
  }
};

/// Friction that begins to slip at a larger force than that with which it slips.
TEST(MarchedMotion, SliderThatBreaksAway) {
  const elements::Slider law{2.2e4, 50, 60};
  constexpr double slips_from = 31;  // [rad/s]
  expect_agreement(
      elements::HystereticForce(law),
      [law](double omega, const Vector3d& start, double* largest) {
        return BreakingAway{law}.after_a_period(omega, start, largest);
      },
      law.limit(), slips_from);
}

}  // namespace marched_motion_test
