// SPDX-License-Identifier: BSD-3-Clause
// Response spectrum analysis against closed forms, and of one mode against its time history.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "support/random_system.h"
#include "support/transient.h"
#include "trivet/excitation/shock_spectrum.h"
#include "trivet/excitation/signal.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/response/transient/earthquake.h"
#include "trivet/spatial/rigid_motion.h"

namespace earthquake_test {

using namespace trivet;
using test::along;
using test::RelativelyNear;

constexpr double round_off = 1e-10;      // modes of one or two coordinates
constexpr double step_by_step = 1e-9;    // 1200 steps, each exact to round-off, and a maximum between two of them
constexpr double skew_round_off = 1e-8;  // modes of 18 coordinates with condition up to 1e5

TEST(Earthquake, TwoEqualStoreysHaveTheClosedForm) {
  // Two masses m on two springs k: ω² = (3 ∓ √5)/2 k/m, shapes (1, (1 ± √5)/2); S_a = 2 m/s² at every frequency.
  const double k = 1000, m = 4;
  const auto project = test::project(test::chain({m, m}, {k, k, 0}, {}));
  const model::System& system = project.base().system;
  const assembly::Assembled assembled = assembly::assemble(system);
  const excitation::ResponseSpectrum flat{{0.1, 1000}, {2, 2}, 0};
  const auto channels =
      assembly::channels(system, assembled, {"m2.x", "ground.force.x"}, assembly::MotionQuantity::displacement);
  const auto r = response::earthquake_response(assembled, channels, flat, along(0));
  double squares = 0, mass = 0;
  for (int i = 0; i < 2; ++i) {
    const double sign = i == 0 ? 1 : -1, root = std::sqrt(5.0);
    const double squared = (3 - sign * root) / 2 * k / m, top = (1 + sign * root) / 2, modal_mass = m * (1 + top * top),
                 gamma = m * (1 + top) / modal_mass;
    EXPECT_THAT(r.modes[i].angular_frequency, RelativelyNear(std::sqrt(squared), round_off));
    EXPECT_THAT(r.modes[i].effective_mass, RelativelyNear(gamma * gamma * modal_mass, round_off));
    EXPECT_THAT(std::abs(r.channels[0].modal_maxima(i)),
                RelativelyNear(std::abs(gamma * top * 2 / squared), round_off));
    EXPECT_THAT(std::abs(r.channels[1].modal_maxima(i)),
                RelativelyNear(2 * gamma * gamma * modal_mass, round_off));  // base force: S_a times the effective mass
    squares += std::pow(gamma * top * 2 / squared, 2);
    mass += r.modes[i].effective_mass;
  }
  EXPECT_THAT(r.channels[0].square_root_of_sum_of_squares, RelativelyNear(std::sqrt(squares), round_off));
  EXPECT_THAT(mass, RelativelyNear(2 * m, round_off));
  EXPECT_THAT(r.effective_mass_share, RelativelyNear(1.0, round_off));
}

TEST(Earthquake, OneModeHasTheLargestValueOfItsTimeHistory) {
  const double omega = 12, zeta = 0.05, mass = 2;
  excitation::Samples record;
  for (int i = 0; i < 800; ++i) {
    record.times.push_back(0.01 * i);
    record.values.push_back(i == 799 ? 0 : 3 * std::sin(0.11 * i + 1e-4 * i * i) * std::exp(-0.004 * i));
  }
  const excitation::Signal shaking = excitation::from_samples(record);
  excitation::ResponseSpectrum spectrum{{}, {}, zeta};
  for (const double w : {omega / 2, omega, omega * 2}) {
    spectrum.angular_frequencies.push_back(w);
    spectrum.accelerations.push_back(w * w * excitation::shock_spectrum(shaking, {w}, zeta)[0].relative_displacement);
  }
  const auto project = test::project(test::chain({mass}, {mass * omega * omega, 0}, {2 * zeta * omega * mass}));
  const model::System& system = project.base().system;
  const assembly::Assembled assembled = assembly::assemble(system);
  const auto channels =
      assembly::channels(system, assembled, {"m1.relative.x"}, assembly::MotionQuantity::displacement);
  const auto r = response::earthquake_response(assembled, channels, spectrum, along(0));
  response::TransientOptions options;
  options.to = 12;
  options.step = 0.01;
  const auto history = test::transient(system, assembled, {"m1.relative.x"},
                                       {test::base_motion(assembled, shaking, along(0), 2)}, options);
  const double largest = std::max(history.curves[0].largest.value, -history.curves[0].smallest.value);
  EXPECT_THAT(r.channels[0].complete_quadratic, RelativelyNear(largest, step_by_step));
  EXPECT_TRUE(r.warnings.list().empty());
  EXPECT_NEAR(r.modes[0].damping_ratio, zeta, round_off);
}

TEST(Earthquake, ShakesTheMassOfSkewBodiesAlongEveryDirection) {
  // For a translation Σ Γ² is the mass of all bodies, for any poles and axes.
  const model::System system = test::checked(test::RandomSystem(8).description(3, test::RandomDamping::proportional));
  const assembly::Assembled assembled = assembly::assemble(system);
  const excitation::ResponseSpectrum flat{{1e-2, 1e5}, {1, 1}, 0.05};
  double mass = 0;
  for (const auto& body : system.bodies()) mass += body.mass.mass;
  for (int axis = 0; axis < 3; ++axis) {
    double sum = 0;
    for (const auto& mode : response::earthquake_response(assembled, {}, flat, along(axis)).modes)
      sum += mode.effective_mass;
    EXPECT_THAT(sum, RelativelyNear(mass, skew_round_off));
  }
}

TEST(Earthquake, WarnsOfModesAndDampingBeyondItsSpectrum) {
  const auto project = test::project(test::chain({4, 4}, {1000, 1000, 0}, {20, 20}));
  const assembly::Assembled assembled = assembly::assemble(project.base().system);
  const excitation::ResponseSpectrum narrow{{20, 1000}, {2, 2}, 0.05};
  const auto r = response::earthquake_response(assembled, {}, narrow, along(0));
  ASSERT_EQ(r.warnings.list().size(), 2u);
  EXPECT_THAT(message(r.warnings.list()[0]), testing::HasSubstr("5 % of the effective mass"));
  EXPECT_THAT(message(r.warnings.list()[1]), testing::HasSubstr("spectrum for 0.05"));
  const auto channels =
      assembly::channels(project.base().system, assembled, {"base.x"}, assembly::MotionQuantity::displacement);
  EXPECT_THROW(static_cast<void>(response::earthquake_response(assembled, channels, narrow, along(0))),
               foundation::NotComputable);
}

}  // namespace earthquake_test
