// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/hysteresis.h"

#include <gmock/gmock.h>

#include <cmath>

#include "support/matchers.h"

namespace hysteresis_test {

using namespace trivet::elements;
using trivet::test::RelativelyNear;

const std::vector<HystereticForce>& laws() {
  static const std::vector<HystereticForce> all = {
      Slider{2e4, 30},
      BergFriction{500, 2e-4},
      BoucWen{.stiffness = 45e3, .force = 180, .exponent = 1},
      BoucWen{.stiffness = 45e3, .force = 180, .exponent = 1.5, .beta = 0.6, .gamma = 0.4},
      BoucWen{.stiffness = 45e3, .force = 180, .exponent = 2, .beta = 0.8, .gamma = -0.5},
      BoucWen{.stiffness = 45e3, .force = 180, .exponent = 7.3, .beta = 0.3, .gamma = 0.3},
      BoucWen{.stiffness = 45e3, .force = 180, .exponent = 1.2, .beta = 0.5, .gamma = 0.4, .asymmetry = 0.1},
      BoucWen{.stiffness = 45e3, .force = 180, .exponent = 1, .beta = 0.3, .gamma = 0.7},  // feeds energy
  };
  return all;
}

TEST(Hysteresis, DerivativesAreThoseOfTheForce) {
  for (std::size_t i = 0; i < laws().size(); ++i)
    for (const double start : {-0.9, -0.4, 0.0, 0.3})
      for (const double travel : {-1.1e-3, 0.7e-3, 2.3e-3, 9e-3}) {
        SCOPED_TRACE(testing::Message() << "law " << i << ", start " << start << ", travel " << travel);
        const double limit = force_limit(laws()[i]), from = start * limit;
        const auto force = [&](double f0, double u) { return force_on_travel(laws()[i], f0, u).force; };
        const ForceOnTravel found = force_on_travel(laws()[i], from, travel);
        constexpr double step = 1e-6;
        const double travel_step = step * 1e-3, force_step = step * limit;
        const double by_travel =
            (force(from, travel + travel_step) - force(from, travel - travel_step)) / (2 * travel_step);
        const double by_start =
            (force(from + force_step, travel) - force(from - force_step, travel)) / (2 * force_step);
        EXPECT_NEAR(found.by_travel, by_travel, 1e-6 * initial_stiffness(laws()[i]));
        EXPECT_NEAR(found.by_start, by_start, 1e-6);
        EXPECT_LE(std::abs(found.force), limit * (1 + 1e-14));
      }
}

TEST(Hysteresis, TravelInTwoPartsIsTravelInOneExceptForBerg) {
  for (const HystereticForce& law : laws()) {
    if (std::holds_alternative<BergFriction>(law)) continue;  // begins anew at each turning point
    const double from = -0.7 * force_limit(law);
    for (const double first : {0.2e-3, 1e-3, 3e-3})
      EXPECT_NEAR(force_on_travel(law, force_on_travel(law, from, first).force, 4e-3 - first).force,
                  force_on_travel(law, from, 4e-3).force, 1e-12 * force_limit(law));
  }
}

/// dz/du by Runge and Kutta's method with 20,000 steps.
TEST(Hysteresis, BoucWenForcesObeyTheirDifferentialEquation) {
  for (const HystereticForce& one : laws()) {
    const auto* law = std::get_if<BoucWen>(&one);
    if (!law) continue;
    const double travel = 6e-3;
    double z = -0.8 * force_limit(one) / law->force;
    const auto slope = [&](double at) {
      return law->stiffness / law->force *
          (1 -
           (law->gamma + (at > 0 ? law->beta + 2 * law->asymmetry : -law->beta)) *
               std::pow(std::abs(at), law->exponent));
    };
    constexpr int steps = 20'000;
    const double h = travel / steps, start = z * law->force;
    for (int i = 0; i < steps; ++i) {
      const double k1 = slope(z), k2 = slope(z + h / 2 * k1), k3 = slope(z + h / 2 * k2), k4 = slope(z + h * k3);
      z += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    constexpr double across_zero = 2e-8;  // one step passes a kink of the slope
    EXPECT_NEAR(force_on_travel(one, start, travel).force, law->force * z, across_zero * law->force);
  }
}

TEST(Hysteresis, KinksAreWhereASliderSlipsAndAForceChangesItsSign) {
  EXPECT_THAT(*HystereticBranch(Slider{2e4, 30}, -30, 1).kink(), RelativelyNear(60 / 2e4, 1e-15));
  EXPECT_THAT(*HystereticBranch(Slider{2e4, 30}, 10, -1).kink(), RelativelyNear(-40 / 2e4, 1e-15));
  EXPECT_FALSE(HystereticBranch(BergFriction{500, 2e-4}, -100, 1).kink());
  for (const HystereticForce& law : laws()) {
    if (!std::holds_alternative<BoucWen>(law)) continue;
    const double from = 0.6 * force_limit(law);
    EXPECT_FALSE(HystereticBranch(law, from, 1).kink());
    EXPECT_NEAR(force_on_travel(law, from, *HystereticBranch(law, from, -1).kink()).force, 0, 1e-13 * force_limit(law));
  }
}

}  // namespace hysteresis_test
