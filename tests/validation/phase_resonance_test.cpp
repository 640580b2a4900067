// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/branch/steady_branch.h"

/// Motions that lag their force by 90°, over the force.
namespace phase_resonance_test {

using namespace trivet;
using test::RelativelyNear;

constexpr double mass = 3, stiffness = 1200, damping = 4, cubic = 2e7, load = 5;

model::System hardening(double coefficient) {
  model::Description description =
      test::project(test::chain({mass}, {stiffness, 0}, {damping, 0}) +
                    "\n[excitations.F]\ntype = \"harmonic\"\non = \"m1\"\nat = [0, 0, 0]\nforce = [5, 0, 0]\n")
          .base()
          .system.description();
  description.elements[0].nonlinear_parts = {
      {0, 0.5, {elements::ElasticForce(elements::PolynomialForce{{0, 0, coefficient}})}}};
  return model::System::checked(description).value();
}

nonlinear::SteadyOptions at_90_degrees(Eigen::Index harmonics) {
  nonlinear::SteadyOptions options{.from = 0.01, .to = 2};
  options.over = nonlinear::Parameter::load_factor;
  options.at_phase = {"m1.x", std::numbers::pi / 2, 2, 100};
  options.harmonics = harmonics;
  options.of = {"m1.x"};
  return options;
}

/// One harmonic: c ω A = F, m ω² = k + ¾ c₃ A².
TEST(PhaseResonance, OfOneHarmonicIsTheClosedForm) {
  const nonlinear::SteadyBranch found = nonlinear::steady_branch(hardening(cubic), at_90_degrees(1));
  ASSERT_GT(found.points.size(), 10u);
  EXPECT_EQ(found.ended, "");
  EXPECT_THAT(found.points.back().load_factor, RelativelyNear(2, 1e-12));
  for (const nonlinear::SteadyPoint& point : found.points) {
    const double omega = point.angular_frequency, amplitude = std::abs(point.results[0].harmonics(0));
    EXPECT_THAT(damping * omega * amplitude, RelativelyNear(load * point.load_factor, 1e-9));
    EXPECT_THAT(mass * omega * omega, RelativelyNear(stiffness + 0.75 * cubic * amplitude * amplitude, 1e-9));
    EXPECT_NEAR(point.results[0].harmonics(0).real(), 0, 1e-9 * amplitude);
  }
}

/// The origin of time has no part in it: neither a phase of the force nor its delay, which changes with the frequency.
TEST(PhaseResonance, LagsTheForceWhateverItsPhase) {
  struct Shift {
    std::complex<double> factor;
    double delay;
  };
  for (const Shift& shift : {Shift{std::polar(1.0, 1.1), 0}, Shift{-1, 0}, Shift{1, 0.013}, Shift{{0, -1}, 0.004}}) {
    model::Description shifted = hardening(cubic).description();
    shifted.excitations[0].action.amplitude *= shift.factor;
    shifted.excitations[0].action.delay = shift.delay;
    const nonlinear::SteadyBranch found =
        nonlinear::steady_branch(model::System::checked(shifted).value(), at_90_degrees(1));
    ASSERT_GT(found.points.size(), 10u);
    ASSERT_TRUE(found.at_phase);
    EXPECT_EQ(found.at_phase->behind, "F");
    for (const nonlinear::SteadyPoint& point : found.points) {
      const double omega = point.angular_frequency, amplitude = std::abs(point.results[0].harmonics(0));
      EXPECT_THAT(damping * omega * amplitude, RelativelyNear(load * point.load_factor, 1e-9));
      EXPECT_THAT(mass * omega * omega, RelativelyNear(stiffness + 0.75 * cubic * amplitude * amplitude, 1e-9));
      EXPECT_TRUE(point.stable);
    }
  }
}

TEST(PhaseResonance, NeedsTheHarmonicsOfItsOrders) {
  const model::System two_orders =
      test::project(test::chain({mass}, {stiffness, 0}, {damping, 0}) +
                    "\n[excitations.F]\ntype = \"orders\"\non = \"m1\"\nat = [0, 0, 0]\n"
                    "table = [{order = 1, force = [5, 0, 0]}, {order = 2, force = [1, 0, 0]}]\n")
          .base()
          .system;
  EXPECT_THAT([&] { (void)nonlinear::steady_branch(two_orders, at_90_degrees(1)); },
              testing::ThrowsMessage<foundation::InvalidInput>(testing::HasSubstr("take at least 2")));
}

/// The motion over frequency at the same load has its largest first harmonic there, to the damping.
TEST(PhaseResonance, IsThePeakOverFrequency) {
  const nonlinear::SteadyBranch found = nonlinear::steady_branch(hardening(cubic), at_90_degrees(9));
  ASSERT_FALSE(found.points.empty());
  const nonlinear::SteadyPoint* whole = &found.points.front();  // nearest to the whole load
  for (const nonlinear::SteadyPoint& point : found.points)
    if (std::abs(point.load_factor - 1) < std::abs(whole->load_factor - 1)) whole = &point;
  nonlinear::SteadyOptions over_frequency{.from = 5, .to = 100};
  over_frequency.harmonics = 9;
  over_frequency.of = {"m1.x"};
  over_frequency.at = {whole->angular_frequency};
  model::Description scaled = hardening(cubic).description();
  scaled.excitations[0].action.amplitude *= whole->load_factor;
  const nonlinear::SteadyBranch curve =
      nonlinear::steady_branch(model::System::checked(scaled).value(), over_frequency);
  double nearest = 1;
  for (const nonlinear::SteadyPoint& point : curve.at)
    nearest = std::min(nearest, std::abs(point.results[0].harmonics(0) - whole->results[0].harmonics(0)));
  EXPECT_LT(nearest, 1e-9 * std::abs(whole->results[0].harmonics(0)));
  double largest = 0;
  for (const nonlinear::SteadyPoint& point : curve.points)
    largest = std::max(largest, std::abs(point.results[0].harmonics(0)));
  EXPECT_THAT(std::abs(whole->results[0].harmonics(0)), RelativelyNear(largest, 1e-2));
}

}  // namespace phase_resonance_test
