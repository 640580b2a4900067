// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/branch/steady_branch.h"

/// A mass on a spring with Coulomb friction under a harmonic force: the closed form of Den Hartog, Trans. ASME 53
/// (1931) for motion that does not rest, and the product of its multipliers.
namespace coulomb_friction_test {

using namespace trivet;
using test::RelativelyNear;

constexpr double pi = std::numbers::pi;
constexpr double mass = 2, stiffness = 1800, load = 12, slip = 4;

model::System with_friction(double static_limit, double damping = 0) {
  model::Description description =
      test::project(test::chain({mass}, {stiffness, 0}, {damping, 0}) +
                    "\n[excitations.F]\ntype = \"harmonic\"\non = \"m1\"\nat = [0, 0, 0]\nforce = [12, 0, 0]\n")
          .base()
          .system.description();
  description.elements[0].nonlinear_parts = {
      {0, 0.5, {elements::HystereticForce(elements::CoulombFriction{slip, static_limit})}}};
  return model::System::checked(description).value();
}

nonlinear::SteadyBranch branch_of(const model::System& system, Eigen::Index harmonics, std::vector<double> at) {
  nonlinear::SteadyOptions options{.from = at.front() - 1, .to = at.back() + 1};
  options.harmonics = harmonics;
  options.of = {"m1.x"};
  options.at = std::move(at);
  return nonlinear::steady_branch(system, options);
}

/// Largest deflection, and the force on the mass without friction where it turns.
struct DenHartog {
  double largest = 0, turning_force = 0;
};
DenHartog den_hartog(double omega) {
  const double ratio = omega / std::sqrt(stiffness / mass), V = 1 / (1 - ratio * ratio),
               U = std::sin(pi / ratio) / (ratio * (1 + std::cos(pi / ratio)));
  const double largest = load / stiffness * std::sqrt(V * V - std::pow(slip / load * U, 2));
  // Where the deflection is largest, the phase of the load has the cosine x k/(V F), so that the spring less the load
  // is k x (1 − 1/V).
  return {largest, stiffness * largest * (1 - 1 / V)};
}

TEST(CoulombFriction, IsTheMotionOfDenHartog) {
  const model::System system = with_friction(slip);
  const std::vector<double> at = {18, 22, 26, 28.5};
  const auto largest_error = [&](Eigen::Index harmonics) {
    const nonlinear::SteadyBranch branch = branch_of(system, harmonics, at);
    double largest = 0;
    EXPECT_EQ(branch.at.size(), at.size());
    for (std::size_t i = 0; i < branch.at.size(); ++i) {
      largest = std::max(largest, std::abs(branch.at[i].results[0].largest / den_hartog(at[i]).largest - 1));
      EXPECT_TRUE(branch.at[i].stable);
    }
    return largest;
  };
  // The turning points are corrected for the missing harmonics: the error falls as their square.
  EXPECT_LT(largest_error(21), 3e-4);
  EXPECT_LT(largest_error(99), 2e-5);
}

/// Each turn takes the share a⁺/a⁻ of a variation of the velocity, with the accelerations after and before it.
TEST(CoulombFriction, MultipliersAreTheSharesOfTwoTurns) {
  const nonlinear::SteadyBranch branch = branch_of(with_friction(slip), 99, {22, 26});
  ASSERT_EQ(branch.at.size(), 2u);
  for (const nonlinear::SteadyPoint& point : branch.at) {
    const double force = den_hartog(point.angular_frequency).turning_force;
    const double share = (force - slip) / (force + slip);
    std::complex<double> product = 1;
    for (const std::complex<double>& one : point.multipliers)
      if (std::abs(one) > 1e-6) product *= one;  // those of the memory of the loop are zero
    EXPECT_NEAR(product.real(), share * share, 2e-3);
  }
}

/// Where the static limit holds the deflection, its force is not known.
TEST(CoulombFriction, IsNotComputedWhereItRests) {
  const auto rests =
      testing::ThrowsMessage<foundation::NotComputable>(testing::HasSubstr("rests for a part of the period"));
  EXPECT_THAT([] { (void)branch_of(with_friction(11), 15, {18, 19.5}); }, rests);
  // A load that does not move it at all: the rate of the harmonics never becomes that of a turning point.
  model::Description weak = with_friction(slip).description();
  weak.excitations[0].action.amplitude *= 0.04;
  EXPECT_THAT([&] { (void)branch_of(model::System::checked(weak).value(), 9, {18, 22}); },
              testing::ThrowsMessage<foundation::NotComputable>(testing::HasSubstr("it does not move at all")));
}

/// A band from below: the curve begins where it does not rest, and goes down to where the force at its turns would hold
/// it.
TEST(CoulombFriction, BeginsAboveThePlaceWhereItRests) {
  double rests = 12, moves = 18;
  for (int i = 0; i < 60; ++i) {
    const double middle = (rests + moves) / 2;
    (den_hartog(middle).turning_force < slip ? rests : moves) = middle;
  }
  nonlinear::SteadyOptions options{.from = 8, .to = 28};
  options.harmonics = 61;
  const nonlinear::SteadyBranch branch = nonlinear::steady_branch(with_friction(slip), options);
  ASSERT_TRUE(branch.begun_at);
  EXPECT_GT(*branch.begun_at, moves);
  EXPECT_THAT(branch.ended, testing::HasSubstr("rests for a part of the period"));
  double lowest = options.to, highest = 0;
  for (const nonlinear::SteadyPoint& point : branch.points) {
    lowest = std::min(lowest, point.angular_frequency);
    highest = std::max(highest, point.angular_frequency);
  }
  EXPECT_THAT(lowest, RelativelyNear(moves, 2e-3));  // a step of 1e-4 of the band, and 61 harmonics
  EXPECT_DOUBLE_EQ(highest, options.to);
}

/// Without a damper the load feeds more than the friction takes, as the slip is less than π/4 of the load.
TEST(CoulombFriction, EndsAtAnUnboundedResonance) {
  nonlinear::SteadyOptions options{.from = 20, .to = 40};
  options.harmonics = 15;
  options.of = {"m1.x"};
  const nonlinear::SteadyBranch branch = nonlinear::steady_branch(with_friction(slip), options);
  EXPECT_THAT(branch.ended, testing::HasSubstr("grows without limit"));
  EXPECT_FALSE(branch.begun_at);
  EXPECT_THAT(branch.points.front().angular_frequency, RelativelyNear(20, 1e-12));
  EXPECT_THAT(branch.points.back().angular_frequency, RelativelyNear(std::sqrt(stiffness / mass), 1e-5));
  EXPECT_LT(branch.points.back().results[0].half_of_range(), 1e7 * load / stiffness);
}

/// Two halves side by side are one whole: the same motion, and at rest for the same loads.
TEST(CoulombFriction, TwoHalvesAreOneWhole) {
  const auto halves = [](double load_share) {
    model::Description description = with_friction(slip).description();
    description.excitations[0].action.amplitude *= load_share;
    model::Element& one = description.elements[0];
    one.law.scale = 0.5;
    one.nonlinear_parts[0].laws = {elements::HystereticForce(elements::CoulombFriction{slip / 2, slip / 2})};
    description.elements.push_back(one);
    description.elements[1].name = "second";
    return model::System::checked(description).value();
  };
  constexpr double of_turns = 2e-3;  // each corrected alone
  const nonlinear::SteadyBranch branch = branch_of(halves(1), 99, {22, 26});
  ASSERT_EQ(branch.at.size(), 2u);
  for (const nonlinear::SteadyPoint& point : branch.at)
    EXPECT_THAT(point.results[0].largest, RelativelyNear(den_hartog(point.angular_frequency).largest, of_turns));
  EXPECT_THAT([&] { (void)branch_of(halves(0.5), 9, {13, 14}); }, testing::Throws<foundation::NotComputable>());
}

/// The second verdict has the jumps too.
TEST(CoulombFriction, BothVerdictsAgree) {
  nonlinear::SteadyOptions options{.from = 18, .to = 28};
  options.harmonics = 9;
  options.deep = true;
  const nonlinear::SteadyBranch branch = nonlinear::steady_branch(with_friction(slip, 3), options);
  EXPECT_GT(branch.winding.points, 5);
  EXPECT_EQ(branch.winding.undecided, 0);
  EXPECT_TRUE(branch.winding.differs_at.empty());
}

}  // namespace coulomb_friction_test
