// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/rope_fit.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

#include "support/matchers.h"

namespace rope_fit_test {

using namespace trivet;
using test::RelativelyNear;

constexpr double stiffness = 4000, quadratic = 2e5, cubic = 2e7;
constexpr elements::BoucWen friction{.stiffness = 11000, .force = 45, .exponent = 1.5};

/// A rig's record of three periods, after the loop has closed in two others: marched in small steps.
identification::LoopFit measured(double amplitude, double noise) {
  constexpr int per_period = 4000, kept = 20;
  identification::LoopRecord record;
  record.displacement.resize(3 * per_period / kept);
  record.force.resize(record.displacement.size());
  std::mt19937 random(7);
  std::normal_distribution<double> scatter(0, noise);
  double z = 0;
  for (int i = 0; i < 5 * per_period; ++i) {
    const auto at = [&](double step) { return amplitude * std::sin(2 * std::numbers::pi * step / per_period); };
    const double travel = at(i + 1) - at(i);
    const auto slope = [&](double now) {
      return friction.stiffness / friction.force *
          (1 - (0.5 + 0.5 * (now * travel > 0 ? 1 : -1)) * std::pow(std::abs(now), friction.exponent));
    };
    z += travel * slope(z + travel / 2 * slope(z));
    const int shown = i + 1 - 2 * per_period;
    if (shown < 0 || shown % kept != 0 || shown / kept >= record.force.size()) continue;
    const double x = at(i + 1);
    record.displacement(shown / kept) = x;
    record.force(shown / kept) =
        12 + stiffness * x + quadratic * x * x + cubic * x * x * x + friction.force * z + scatter(random);
  }
  return identification::loop_fit(record).value();
}

TEST(RopeFit, FindsTheNumbersOfItsLoops) {
  std::vector<identification::LoopFit> loops;
  for (const double amplitude : {0.5e-3, 2e-3, 6e-3, 12e-3}) loops.push_back(measured(amplitude, 0));
  const identification::RopeFit found = identification::rope_fit(loops).value();
  constexpr double of_samples = 2e-3;  // harmonics of 200 samples per period
  EXPECT_THAT(found.stiffness, RelativelyNear(stiffness, of_samples));
  EXPECT_THAT(found.quadratic, RelativelyNear(quadratic, of_samples));
  EXPECT_THAT(found.cubic, RelativelyNear(cubic, of_samples));
  EXPECT_THAT(found.friction.stiffness, RelativelyNear(friction.stiffness, of_samples));
  EXPECT_THAT(found.friction.force, RelativelyNear(friction.force, of_samples));
  EXPECT_THAT(found.friction.exponent, RelativelyNear(friction.exponent, 1e-2));
  EXPECT_LT(found.relative_rms, 1e-3);
}

TEST(RopeFit, IsNearWithTheNoiseOfARig) {
  std::vector<identification::LoopFit> loops;
  for (const double amplitude : {0.5e-3, 2e-3, 6e-3, 12e-3}) loops.push_back(measured(amplitude, 1.0));
  const identification::RopeFit found = identification::rope_fit(loops).value();
  constexpr double of_noise = 0.1;
  EXPECT_THAT(found.stiffness, RelativelyNear(stiffness, of_noise));
  EXPECT_THAT(found.friction.force, RelativelyNear(friction.force, of_noise));
}

TEST(RopeFit, NeedsAmplitudesThatDiffer) {
  EXPECT_THAT(identification::rope_fit({measured(2e-3, 0), measured(2.2e-3, 0)}).error().list().front().rule,
              testing::HasSubstr("differ by a factor of two"));
}

}  // namespace rope_fit_test
