// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <Eigen/LU>
#include <cmath>
#include <complex>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/nonlinear/branch/steady_branch.h"

/// Poles that repeat with one shape only have no residues. Steady motion there, exactly and nearly.
namespace critical_damping_test {

using namespace trivet;
using nonlinear::SteadyBranch;
using nonlinear::SteadyPoint;
using test::RelativelyNear;

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;
constexpr double beside[] = {0, 1e-9, -1e-9, 1e-6, -1e-6, 1e-3, -1e-3};

/// 1 kg on 100 N/m and a damper between stops on both sides, under 5 N.
model::System between_stops(double damping, double gap) {
  const auto stop = [&](const char* name, const char* axis) {
    return fmt::format(
        "[elements.{}]\ntype = \"stop\"\non = \"m\"\nat = [0, 0, 0]\naxis = \"{}\"\ngap = {}\nstiffness = 2000\n", name,
        axis, gap);
  };
  return test::project(fmt::format(R"(trivet = 1
[bodies.m]
mass = 1
free = ["x"]
[excitations.f]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [5, 0, 0]
[elements.d]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [100, 0, 0]
damping = {{translation = [{}, 0, 0]}}
{}{})",
                                   damping, stop("right", "x"), stop("left", "-x")))
      .base()
      .system;
}

TEST(CriticalDamping, MotionBetweenStopsThatAreNotTouched) {
  for (const double share : beside) {
    SCOPED_TRACE(share);
    const double c = 20 * (1 + share);
    nonlinear::SteadyOptions options{.from = 4 * pi, .to = 6 * pi};
    options.of = {"m.x"};
    const SteadyBranch found = nonlinear::steady_branch(between_stops(c, 1), options);
    ASSERT_THAT(found.points, testing::Not(testing::IsEmpty()));
    for (const SteadyPoint& point : found.points) {
      const double omega = point.angular_frequency;
      const Complex expected = 5.0 / Complex(100 - omega * omega, c * omega);
      EXPECT_LT(std::abs(point.results[0].harmonics(0) - expected), 1e-9 * std::abs(expected));
      // Multipliers e^{sT} of s² + c s + 100 = 0.
      const Complex root = -c / 2 + std::sqrt(Complex(c * c / 4 - 100));
      constexpr double split = 1e-7;  // round-off separates a double multiplier by its root
      EXPECT_NEAR(point.largest_multiplier(), std::exp(root.real() * 2 * pi / omega), split);
      EXPECT_TRUE(point.stable);
    }
  }
}

/// Marched in time: ±5.895709700236869 mm at 2 Hz.
TEST(CriticalDamping, MotionBetweenStopsThatAreTouched) {
  double before = 0;
  for (const double share : beside) {
    nonlinear::SteadyOptions options{.from = 4 * pi, .to = 6 * pi, .harmonics = 41};
    options.of = {"m.x"};
    const SteadyBranch found = nonlinear::steady_branch(between_stops(20 * (1 + share), 0.002), options);
    ASSERT_THAT(found.points, testing::Not(testing::IsEmpty()));
    const double largest = found.points.front().results[0].largest;
    if (share == 0) {
      EXPECT_THAT(largest, RelativelyNear(5.895709700236869e-3, 1e-5));
      before = largest;
    }
    EXPECT_THAT(largest, RelativelyNear(before, 1e-7 + std::abs(share)));
  }
}

/// Two oscillators of 1 kg whose two oscillating pairs are one: (s² + a s + b)² is the characteristic polynomial, with
/// the second spring and damper by its coefficients. The matrix of the states has one pair of eigenvectors.
TEST(CriticalDamping, TwoOscillatingPairsThatAreOne) {
  constexpr double k2 = 100.2375846781509, c2 = 1.396545277677542;
  for (const double share : beside) {
    SCOPED_TRACE(share);
    Eigen::Matrix2cd K, C;
    K << 102, -2, -2, k2 + 2;
    C << 1, 0, 0, c2 * (1 + share);
    const auto spring = [](const char* name, const char* on, double k, double c) {
      return fmt::format(
          "[elements.{}]\ntype = \"three_springs\"\non = \"{}\"\nat = [0, 0, 0]\ntranslation = [{}, 0, 0]\n"
          "damping = {{translation = [{}, 0, 0]}}\n",
          name, on, k, c);
    };
    const model::System system =
        test::project("trivet = 1\n[bodies.a]\nmass = 1\nfree = [\"x\"]\n[bodies.b]\nmass = 1\nfree = [\"x\"]\n" +
                      spring("ga", "a", 100, 1) + spring("gb", "b", k2, c2 * (1 + share)) + spring("ab", "a", 2, 0) +
                      R"(from = "b"
[elements.far]
type = "stop"
on = "b"
at = [0, 0, 0]
axis = "x"
gap = 10
stiffness = 2000
[excitations.f]
type = "harmonic"
on = "a"
at = [0, 0, 0]
force = [5, 0, 0]
)")
            .base()
            .system;
    nonlinear::SteadyOptions options{.from = 6, .to = 14};
    options.of = {"a.x", "b.x"};
    const SteadyBranch found = nonlinear::steady_branch(system, options);
    ASSERT_THAT(found.points, testing::Not(testing::IsEmpty()));
    for (const SteadyPoint& point : found.points) {
      const double omega = point.angular_frequency;
      const Eigen::Matrix2cd Z = K + Complex(0, omega) * C - omega * omega * Eigen::Matrix2cd::Identity();
      const Eigen::Vector2cd q = Z.fullPivLu().solve(Eigen::Vector2cd(5, 0));
      for (Eigen::Index i = 0; i < 2; ++i)
        EXPECT_LT(std::abs(point.results[static_cast<std::size_t>(i)].harmonics(0) - q(i)), 1e-9 * q.norm());
      EXPECT_TRUE(point.multipliers_hold);
      EXPECT_TRUE(point.stable);
    }
  }
}

}  // namespace critical_damping_test
