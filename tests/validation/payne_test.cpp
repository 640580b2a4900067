// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <complex>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/nonlinear/modes/backbone.h"

/// A mass on rubber whose stiffness and loss follow its amplitude: one harmonic is the exact motion, and its amplitude
/// A that of |k' + i k'' + k + i c ω − m ω²| A = F.
namespace payne_test {

using namespace trivet;
using test::RelativelyNear;

constexpr double mass = 100, stiffness = 2e5, damping = 100, load = 20;

/// Kraus's formulas once more.
std::complex<double> of_rubber(const elements::PayneForce& law, double amplitude) {
  const double square = std::pow(amplitude / law.amplitude, 2 * law.exponent);
  return {law.stiffness / (1 + square), 2 * law.loss * std::sqrt(square) / (1 + square)};
}

model::System on_rubber(const elements::PayneForce& law) {
  model::Description description =
      test::project(test::chain({mass}, {stiffness, 0}, {damping, 0}) +
                    "\n[excitations.F]\ntype = \"harmonic\"\non = \"m1\"\nat = [0, 0, 0]\nforce = [20, 0, 0]\n")
          .base()
          .system.description();
  description.elements[0].nonlinear_parts = {{0, 0.5, {law}}};
  return model::System::checked(description).value();
}

nonlinear::SteadyBranch branch(const elements::PayneForce& law) {
  nonlinear::SteadyOptions options{.from = 20, .to = 90};
  options.of = {"m1.x"};
  return nonlinear::steady_branch(on_rubber(law), options);
}

TEST(Payne, MotionIsThatOfItsOwnAmplitude) {
  constexpr elements::PayneForce law{.stiffness = 3e5, .loss = 6e4, .amplitude = 2e-4, .exponent = 0.55};
  const nonlinear::SteadyBranch found = branch(law);
  ASSERT_GT(found.points.size(), 20u);
  EXPECT_EQ(found.ended, "");
  for (const nonlinear::SteadyPoint& point : found.points) {
    const double omega = point.angular_frequency, amplitude = std::abs(point.results[0].harmonics(0));
    const std::complex<double> dynamic =
        of_rubber(law, amplitude) + std::complex<double>(stiffness - mass * omega * omega, damping * omega);
    EXPECT_THAT(std::abs(dynamic) * amplitude, RelativelyNear(load, 1e-9));
  }
}

/// Its resonance falls from that of small amplitudes to that of large ones, and bends to lower frequencies: where it
/// folds, the middle one of three motions is unstable.
TEST(Payne, MotionsBehindAFoldAreUnstable) {
  const nonlinear::SteadyBranch found = branch({.stiffness = 3e5, .loss = 5e3, .amplitude = 2e-4, .exponent = 1.5});
  ASSERT_EQ(found.folds.size(), 2u);
  std::size_t unstable = 0;
  for (std::size_t i = 0; i < found.points.size(); ++i) {
    const bool between = i > found.folds[0].after && i <= found.folds[1].after;
    EXPECT_EQ(found.points[i].stable, !between) << i;
    unstable += found.points[i].stable ? 0 : 1;
  }
  EXPECT_GT(unstable, 0u);
}

/// Undamped: m ω² = k + k'(A), with the energy m ω² A²/2.
TEST(Payne, UndampedModeHasTheEnergyOfItsAmplitude) {
  constexpr elements::PayneForce law{.stiffness = 3e5, .loss = 6e4, .amplitude = 2e-4, .exponent = 0.55};
  nonlinear::BackboneOptions options;
  options.up_to = 5e-3;
  options.harmonics = 1;
  options.of = {"m1.x"};
  const nonlinear::Backbone found = nonlinear::backbone(on_rubber(law), options);
  ASSERT_GT(found.points.size(), 10u);
  for (const nonlinear::BackbonePoint& point : found.points) {
    const double omega = point.angular_frequency, amplitude = point.results[0].largest;
    EXPECT_THAT(mass * omega * omega, RelativelyNear(stiffness + of_rubber(law, amplitude).real(), 1e-9));
    EXPECT_THAT(point.energy, RelativelyNear(0.5 * mass * omega * omega * amplitude * amplitude, 1e-9));
  }
}

}  // namespace payne_test
