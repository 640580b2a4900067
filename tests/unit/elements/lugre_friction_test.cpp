// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/friction.h"

#include <gmock/gmock.h>

#include <cmath>

#include "support/matchers.h"
#include "trivet/elements/scalar_law.h"

namespace lugre_friction_test {

using namespace trivet;
using elements::LuGreFriction;
using test::RelativelyNear;

constexpr LuGreFriction law{
    .stiffness = 2e5, .slip = 40, .breakaway = 60, .stribeck_velocity = 0.02, .damping = 300, .viscous = 50};

/// In steady slip dz/dt = 0: σ_0 z is the force of steady slip, F_s at small rates and F_c at large ones.
TEST(LuGreFriction, BristlesOfSteadySlipBearTheStribeckCurve) {
  const auto bristle_force = [](double rate) {
    return law.stiffness / elements::bristle_decay(law, rate, rate).per_travel;
  };
  EXPECT_EQ(bristle_force(0), 60);
  EXPECT_THAT(bristle_force(0.02), RelativelyNear(40 + 20 * std::exp(-1.0), 1e-14));
  EXPECT_THAT(bristle_force(-0.03), RelativelyNear(-40 - 20 * std::exp(-2.25), 1e-14));
  EXPECT_EQ(bristle_force(1), 40);
}

TEST(LuGreFriction, DecayHasItsDerivativeByTheRate) {
  constexpr double step = 1e-7, truncation = 1e-7;
  for (const double rate : {-0.05, -0.01, 0.004, 0.02, 0.03}) {
    const double slope = (elements::bristle_decay(law, rate + step, rate).per_travel -
                          elements::bristle_decay(law, rate - step, rate).per_travel) /
        (2 * step);
    EXPECT_THAT(elements::bristle_decay(law, rate, rate).by_rate, RelativelyNear(slope, truncation));
  }
}

/// Slow loading from zero: Dahl's exponential function.
TEST(LuGreFriction, VirginForceApproachesTheBreakaway) {
  for (const double deflection : {-1e-3, -2e-4, 1e-5, 3e-4}) {
    const elements::ForceAndTangent found = elements::force_at_rest({law}, deflection);
    const double left = std::exp(-2e5 * std::abs(deflection) / 60);
    EXPECT_THAT(found.force, RelativelyNear(std::copysign(60 * (1 - left), deflection), 1e-12));
    EXPECT_THAT(found.tangent, RelativelyNear(2e5 * left, 1e-12));
  }
  EXPECT_EQ(elements::small_motion({law}, 1e-3).stiffness, 2e5);
  EXPECT_EQ(elements::small_motion({law}, 1e-3).damping, 350);
  EXPECT_TRUE(elements::is_monotone({law}));
}

TEST(LuGreFriction, NeedsAsMuchViscousFrictionAsBreakawayExceedsSlip) {
  EXPECT_THAT(elements::least_passive_viscous(law), RelativelyNear(150, 1e-14));
  EXPECT_EQ(elements::least_passive_viscous({.stiffness = 1, .slip = 1, .damping = 5}), 0);
}

}  // namespace lugre_friction_test
