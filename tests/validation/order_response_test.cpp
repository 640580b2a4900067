// SPDX-License-Identifier: BSD-3-Clause
// Run-up of simple systems against closed forms.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "support/guided_mass.h"
#include "support/matchers.h"
#include "support/solved_system.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/response/machinery/run_up.h"

namespace order_response_test {

using namespace trivet;
using test::RelativelyNear;
constexpr double round_off = 1e-10;    // solves of one coordinate, with roots and heights from them
constexpr double flat_maximum = 1e-8;  // the place of a maximum is known to the root of round-off
constexpr double same_speed = 1e-12;   // round-off of two ways to a speed of the grid
constexpr double infinity = std::numeric_limits<double>::infinity();

double amplitude_at(const response::RunUp& run_up, std::size_t order, std::size_t curve, double speed) {
  for (std::size_t i = 0; i < run_up.speed.size(); ++i)
    if (std::abs(run_up.speed[i] - speed) < same_speed * speed)
      return std::abs(run_up.orders[order].curves[curve].value(to_index(i)));
  ADD_FAILURE() << "no speed " << speed;
  return 0;
}

TEST(UnbalanceRunUp, PeaksAboveTheNaturalFrequency) {
  // m x'' + c x' + k x = u Ω² e^{iΩt}: largest at Ω = ω0/√(1 − 2ζ²), u/m/(2ζ√(1 − ζ²)). [Den Hartog]
  constexpr double mass = 2, natural = 30, unbalance = 0.01;
  for (const double ratio : {1e-4, 0.02, 0.3, 0.6}) {
    model::Description d = test::guided_mass(mass, natural, ratio);
    d.excitations = {test::vertical_force("unbalance", 0, unbalance, 2)};
    const response::RunUp found = test::SolvedSystem(d).run_up({"machine"}, {0, 200});
    ASSERT_EQ(found.critical.size(), 1u) << ratio;
    const response::CriticalSpeed& critical = found.critical[0];
    EXPECT_THAT(critical.speed, RelativelyNear(natural / std::sqrt(1 - 2 * ratio * ratio), flat_maximum)) << ratio;
    EXPECT_THAT(critical.amplitude,
                RelativelyNear(unbalance / mass / (2 * ratio * std::sqrt(1 - ratio * ratio)), round_off))
        << ratio;
    EXPECT_EQ(critical.order, 1);
    EXPECT_EQ(critical.nearest_mode, 1);
    EXPECT_EQ(critical.relative_height, 1);
    EXPECT_THAT(amplitude_at(found, 0, 0, critical.speed), RelativelyNear(critical.amplitude, round_off))
        << "the peak is on the grid";
    EXPECT_THAT(found.overall[0].highest_rms, RelativelyNear(critical.amplitude / std::numbers::sqrt2, round_off));
    EXPECT_THAT(found.overall[0].highest_rms_at, RelativelyNear(critical.speed, flat_maximum));
  }
}

TEST(UnbalanceRunUp, HasTheAmplitudesOfTheTextbookTable) {
  // M X/(m e) over r at ζ = 0.02 (Den Hartog, Rao).
  constexpr double mass = 3, natural = 50, unbalance = 0.02;
  model::Description d = test::guided_mass(mass, natural, 0.02);
  d.excitations = {test::vertical_force("unbalance", 0, unbalance, 2)};
  const response::RunUp found = test::SolvedSystem(d).run_up({"machine"}, {25, 250}, 10);  // r = 0.5, 1.0, 1.5 …
  EXPECT_THAT(amplitude_at(found, 0, 0, 25) * mass / unbalance, RelativelyNear(0.33321487798725696, round_off));
  EXPECT_THAT(amplitude_at(found, 0, 0, 100) * mass / unbalance, RelativelyNear(1.3328595119490279, round_off));
  EXPECT_THAT(amplitude_at(found, 0, 0, 150) * mass / unbalance, RelativelyNear(1.1248734588534184, round_off));
  EXPECT_THAT(amplitude_at(found, 0, 0, 250) * mass / unbalance, RelativelyNear(1.0416304995688774, round_off));
}

TEST(UnbalanceRunUp, HasNoBoundWithoutDamping) {
  model::Description d = test::guided_mass(2, 30, 0);
  d.excitations = {test::vertical_force("unbalance", 0, 0.01, 2)};
  const response::RunUp found = test::SolvedSystem(d).run_up({"machine"}, {10, 70});
  ASSERT_EQ(found.critical.size(), 1u);
  EXPECT_THAT(found.critical[0].speed, RelativelyNear(30.0, round_off));
  EXPECT_EQ(found.critical[0].amplitude, infinity);
  EXPECT_EQ(found.overall[0].highest_rms, infinity);
}

/// Four cylinders in line, 2 litres: r = 43 mm, λ = 0.3, 0.6 kg oscillating.
excitation::Engine four_in_line() {
  excitation::Engine engine;
  engine.crank_radius = 0.043;
  engine.rod_ratio = 0.3;
  engine.oscillating_mass = 0.6;
  engine.cylinders =
      excitation::evenly_firing_cylinders({excitation::EngineLayout::Kind::in_line, 4, 0, 0.09, 0, {}, 4});
  return engine;
}

TEST(FourInLine, ShakesTheGroundWithItsSecondOrder) {
  // F₂ = 4 m r Ω² A₂ along the cylinders, A₂ = λ + λ³/4 + 15λ⁵/128 + …; first-order forces cancel.
  constexpr double mass = 150, natural = 60, ratio = 0.05, rod = 0.3;
  const double a2 = rod + std::pow(rod, 3) / 4 + 15 * std::pow(rod, 5) / 128, series_end = std::pow(rod, 7);
  model::Description d = test::guided_mass(mass, natural, ratio);
  model::Action on_block;
  on_block.body = 0;
  d.excitations = {{"engine", on_block, model::Orders{excitation::inertia_orders(four_in_line(), 2)}}};
  const test::SolvedSystem solved(d);
  const response::RunUp found = solved.run_up({"ground.force.z"}, {20, 200}, 10);
  ASSERT_EQ(found.orders.size(), 1u);
  EXPECT_EQ(found.orders[0].order, 2);
  for (std::size_t i = 0; i < found.speed.size(); ++i) {
    const double omega = 2 * found.speed[i], force = 4 * 0.6 * 0.043 * found.speed[i] * found.speed[i] * a2,
                 r = omega / natural;
    const double transmitted =
        std::sqrt((1 + 4 * ratio * ratio * r * r) / (std::pow(1 - r * r, 2) + 4 * ratio * ratio * r * r));
    EXPECT_THAT(std::abs(found.orders[0].curves[0].value(to_index(i))), RelativelyNear(force * transmitted, series_end))
        << omega;
  }
  ASSERT_EQ(found.critical.size(), 1u);
  constexpr double shift = 1;  // rad/s: 5 % of damping and the growth of the force move the peak by less
  EXPECT_NEAR(found.critical[0].speed, natural / 2, shift) << "order 2 meets the natural frequency at half its speed";
}

TEST(RunUp, DistinguishesTallPeaksFromSmallOnes) {
  // Equal forces at orders 1 and 2, and 0.9 % and 0.1 % of them at orders 3 and 4: all peak at ω0√(1 − 2ζ²).
  constexpr double natural = 60, ratio = 0.02;
  model::Description d = test::guided_mass(2, natural, ratio);
  model::Action action;
  action.body = 0;
  std::vector<excitation::Order> orders;
  for (const double force : {1.0, 1.0, 0.009, 0.001}) {
    excitation::Order& order = orders.emplace_back();
    order.order = static_cast<double>(orders.size());
    order.fixed(2) = force;
  }
  d.excitations = {{"shaft", action, model::Orders{orders}}};
  const test::SolvedSystem solved(d);
  const response::RunUp found = solved.run_up({"machine"}, {10, 70}, 7);
  ASSERT_EQ(found.critical.size(), 4u);
  const double peak = natural * std::sqrt(1 - 2 * ratio * ratio);
  for (std::size_t i = 0; i < 4; ++i) {
    const double order = 4 - static_cast<double>(i), height = order < 3 ? 1 : order < 4 ? 0.009 : 0.001;
    EXPECT_EQ(found.critical[i].order, order);
    EXPECT_THAT(found.critical[i].speed, RelativelyNear(peak / order, flat_maximum));
    EXPECT_THAT(found.critical[i].relative_height, RelativelyNear(height, round_off));
    const bool on_grid = std::ranges::find(found.speed, found.critical[i].speed) != found.speed.end();
    EXPECT_EQ(on_grid, order < 3) << "from 1 % of the highest";
  }
  EXPECT_THROW(solved.run_up({"machine"}, {10, 10}), foundation::InvalidInput);
  EXPECT_THROW(solved.run_up({"machine"}, {10, 70}, 1), foundation::InvalidInput);
  orders[0].order = 0;
  d.excitations[0].course = model::Orders{orders};
  const test::SolvedSystem force_only(test::guided_mass(2, natural, ratio));
  EXPECT_THROW(force_only.run_up({"machine"}, {10, 70}), foundation::InvalidInput) << "nothing goes with a shaft";
  const model::System resting = test::checked(d);
  EXPECT_THROW((void)response::order_loadings(resting, assembly::assemble(resting)), foundation::InvalidInput)
      << "order 0";
}

TEST(Waterfall, HasALineForEveryOrderOfEverySpectrum) {
  model::Description d = test::guided_mass(2, 30, 0.1);
  d.excitations = {test::vertical_force("unbalance", 0, 0.01, 2)};
  model::Action action;
  action.body = 0;
  excitation::Order half{0.5}, twice{2};
  half.fixed(2) = 3;
  twice.fixed(2) = 1;
  d.excitations.push_back({"gas", action, model::Orders{{half, twice}}});
  const response::RunUp found = test::SolvedSystem(d).run_up({"machine"}, {10, 50}, 41);
  const auto lines = response::waterfall(found, 0, 5);
  ASSERT_EQ(lines.size(), 15u);
  EXPECT_EQ(lines[3].speed, 20);
  EXPECT_EQ(lines[3].order, 0.5);
  EXPECT_THAT(lines[3].amplitude,
              RelativelyNear(3 / std::abs(std::complex<double>(2 * (900 - 100), 2 * 0.1 * 2 * 30 * 10)), round_off));
  EXPECT_EQ(lines[14].angular_frequency, 100);
  const auto uneven = response::waterfall(found, 0, 4);  // 10, 23.3, 36.7 and 50 rad/s
  ASSERT_EQ(uneven.size(), 12u);
  for (std::size_t i = 0; i < 4; ++i) {
    const double wanted = 10 + 40.0 * static_cast<double>(i) / 3;
    for (const double speed : found.speed)
      EXPECT_LE(std::abs(uneven[3 * i].speed - wanted), std::abs(speed - wanted)) << "the nearest of the grid";
  }
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += std::pow(amplitude_at(found, k, 0, 20), 2) / 2;
  const auto at20 = std::ranges::find(found.speed, 20.0) - found.speed.begin();
  EXPECT_THAT(found.overall[0].rms(at20), RelativelyNear(std::sqrt(sum), round_off));
}

/// Two equal masses between two walls by three equal springs: modes (1, 1) at ω0 and (1, −1) at √3 ω0.
model::Description two_masses(double natural, double ratio) {
  model::Description d;
  d.bodies = {test::guided_body("left", 1), test::guided_body("right", 1)};
  const double k = natural * natural, c = 2 * ratio * natural;
  d.elements = {test::vertical_spring("a", {}, 0, k, c), test::vertical_spring("b", 0, 1, k, c),
                test::vertical_spring("c", {}, 1, k, c)};
  return d;
}

TEST(CampbellDiagram, OrdersMeetDampedNaturalFrequencies) {
  constexpr double natural = 40, ratio = 0.05;
  model::Description d = two_masses(natural, ratio);
  model::Action left;
  left.body = 0;
  excitation::Order one{1}, three{3};
  one.per_speed_squared(2) = 0.1;
  three.fixed(2) = 5;
  d.excitations = {{"shaft", left, model::Orders{{one, three}}}};
  const test::SolvedSystem solved(d);
  const response::Campbell found = response::campbell(response::order_loadings(solved.system, solved.assembled),
                                                      solved.modes, solved.roots, {10, 60});
  const double first = natural * std::sqrt(1 - ratio * ratio),
               second = std::sqrt(3.0) * natural * std::sqrt(1 - 3 * ratio * ratio);
  ASSERT_EQ(found.natural.size(), 2u);
  EXPECT_THAT(found.natural[0].angular_frequency, RelativelyNear(first, round_off));
  EXPECT_THAT(found.natural[1].angular_frequency, RelativelyNear(second, round_off));
  EXPECT_THAT(found.natural[1].damping_ratio, RelativelyNear(std::sqrt(3.0) * ratio, round_off));
  ASSERT_EQ(found.points.size(), 3u) << "order 1 meets the second beyond the range";
  const double speeds[] = {first / 3, second / 3, first};
  const int modes[] = {1, 2, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_THAT(found.points[i].speed, RelativelyNear(speeds[i], round_off));
    EXPECT_EQ(found.points[i].mode, modes[i]);
    EXPECT_THAT(*found.points[i].modal_force_share, RelativelyNear(0.5, round_off)) << "one of two masses is pushed";
    EXPECT_TRUE(found.points[i].excited);
  }
}

TEST(CampbellDiagram, ShowsWhichModeAnOrderDoesNotExcite) {
  model::Description d = two_masses(40, 0.02);
  d.excitations = {test::vertical_force("left rotor", 0, 0.1, 2), test::vertical_force("right rotor", 1, 0.1, 2)};
  const test::SolvedSystem solved(d);
  const auto orders = response::order_loadings(solved.system, solved.assembled);
  ASSERT_EQ(orders.size(), 1u) << "equal orders act together";
  EXPECT_THAT(orders[0].excitations, testing::ElementsAre("left rotor", "right rotor"));
  const response::Campbell found = response::campbell(orders, solved.modes, solved.roots, {0, 100});
  ASSERT_EQ(found.points.size(), 2u);
  EXPECT_TRUE(found.points[0].excited);
  EXPECT_THAT(*found.points[0].modal_force_share, RelativelyNear(1.0, round_off));
  EXPECT_FALSE(found.points[1].excited) << "pushed alike they do not swing against each other";
  EXPECT_EQ(response::order_loadings(solved.system, solved.assembled, {"left rotor"}).front().excitations.size(), 1u);
  EXPECT_THROW(static_cast<void>(response::order_loadings(solved.system, solved.assembled, {"left"})),
               foundation::InvalidInput);
}

}  // namespace order_response_test
