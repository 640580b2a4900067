// SPDX-License-Identifier: BSD-3-Clause
// Piston engines against the forces of five engines, computed from the exact kinematics by discrete Fourier transform,
// and against a whole engine in time.
#include "trivet/excitation/engine_orders.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "support/matchers.h"
#include "trivet/foundation/invalid_input.h"

namespace engine_orders_test {

using namespace trivet;
using namespace trivet::excitation;
using Complex = std::complex<double>;
using test::RelativelyNear;
using ::testing::HasSubstr;

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;
constexpr double omega = 314.1592653589793;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double round_off = 1e-12;  // sums over the cylinders

struct Placed {
  double crank_angle, bank_angle, position;
};

Engine engine_of(std::initializer_list<Placed> cylinders) {
  Engine engine{.crank_radius = 0.045, .rod_ratio = 0.3, .oscillating_mass = 0.55};
  for (const Placed& c : cylinders)
    engine.cylinders.push_back({.position = c.position, .bank_angle = c.bank_angle, .crank_angle = c.crank_angle});
  return engine;
}

ComplexVector6 inertia(const Engine& engine, int order) {
  for (const Order& entry : inertia_orders(engine, 6))
    if (entry.order == order) return omega * omega * entry.per_speed_squared;
  return ComplexVector6::Zero();
}

/// Reference values: amplitudes of the vertical and transverse force, and moments Σ position · force; the transverse
/// direction is −y here.
void expect_order(const Engine& engine, int order, Complex vertical, Complex transverse, Complex pitch, Complex yaw) {
  // The references truncate the series of λ after λ⁷: 3e-6 of the second, 3e-4 of the fourth, 1e-2 of the sixth order.
  const double series = order == 6 ? 1e-2 : order == 4 ? 3e-4 : 3e-6;
  constexpr double of_a_zero = 2e-5;  // N, N m: 1e-8 of the force of one cylinder
  const ComplexVector6 w = inertia(engine, order);
  const auto near = [&](Complex actual, Complex expected, const char* name) {
    EXPECT_LE(std::abs(actual - expected), series * std::abs(expected) + of_a_zero)
        << name << " of order " << order << ": " << actual << ", expected " << expected;
  };
  near(w(2), vertical, "F_z");
  near(-w(1), transverse, "-F_y");
  near(-w(4), pitch, "-M_y");
  near(-w(5), yaw, "-M_z");
  EXPECT_EQ(w(0), 0.0);
}

TEST(EngineOrders, InlineFourHasOnlyEvenOrders) {
  const Engine four = engine_of({{0, 0, 0.135}, {pi, 0, 0.045}, {pi, 0, -0.045}, {0, 0, -0.135}});
  expect_order(four, 1, 0, 0, 0, 0);
  expect_order(four, 2, 3000.1638506769664, 0, 0, 0);
  expect_order(four, 4, -70.71885453043328, 0, 0, 0);
  expect_order(four, 6, 1.8753963617404699, 0, 0, 0);
  // In closed form with the exact coefficient: 4 m r Ω² a₂.
  constexpr double all_digits = 1e-10;  // of the coefficient
  EXPECT_THAT(inertia(four, 2)(2).real(),
              RelativelyNear(4 * 0.55 * 0.045 * omega * omega * 0.3070506590621658, all_digits));
  // Cancelled terms are exactly zero, and an order without terms is not listed: the torque of orders 1 and 3 also
  // cancels.
  for (const Order& entry : inertia_orders(four, 6)) EXPECT_EQ(std::fmod(entry.order, 2), 0);
}

TEST(EngineOrders, InlineThreeHasCouples) {
  const Engine three = engine_of({{0, 0, 0.09}, {120 * degree, 0, 0}, {240 * degree, 0, -0.09}});
  expect_order(three, 1, 0, 0, {329.7681570513983, 190.3917342437915}, 0);
  expect_order(three, 2, 0, 0, {101.25552996034756, -58.459907479544945}, 0);
  expect_order(three, 4, 0, 0, {-2.3867613404021255, -1.3779973023725562}, 0);
  expect_order(three, 6, 1.4065472713053524, 0, 0, 0);
  EXPECT_THAT(std::abs(inertia(three, 1)(4)), RelativelyNear(380.78346848758304, round_off));
}

TEST(EngineOrders, InlineSixHasNoOrderBelowTheSixth) {
  const double a = 120 * degree, b = 240 * degree;
  const Engine six =
      engine_of({{0, 0, 0.225}, {a, 0, 0.135}, {b, 0, 0.045}, {b, 0, -0.045}, {a, 0, -0.135}, {0, 0, -0.225}});
  for (const int order : {1, 2, 4}) expect_order(six, order, 0, 0, 0, 0);
  expect_order(six, 6, 2.8130945426107052, 0, 0, 0);
}

TEST(EngineOrders, VeeSixHasPitchAndYawCouples) {
  const double p = 30 * degree, m = -30 * degree;
  const Engine vee = engine_of({{0, p, 0.09},
                                {60 * degree, m, 0.09},
                                {120 * degree, p, 0},
                                {180 * degree, m, 0},
                                {240 * degree, p, -0.09},
                                {300 * degree, m, -0.09}});
  expect_order(vee, 1, 0, 0, {164.88407852569912, 285.5876013656872}, {285.5876013656873, -164.88407852569907});
  expect_order(vee, 2, 0, 0, {-87.68986121931744, -50.62776498017381}, {50.627764980173794, -87.68986121931732});
  expect_order(vee, 4, 0, 0, {-2.0669959535588336, 1.1933806702010616}, {1.1933806702010608, 2.066995953558837});
  expect_order(vee, 6, -2.436211337148236, 0, 0, 0);
}

TEST(EngineOrders, CrossPlaneVeeEightHasAPrimaryCouple) {
  const double p = 45 * degree, m = -45 * degree, q = 90 * degree;
  const Engine vee = engine_of({{0, p, 0.135},
                                {0, m, 0.135},
                                {q, p, 0.045},
                                {q, m, 0.045},
                                {3 * q, p, -0.045},
                                {3 * q, m, -0.045},
                                {2 * q, p, -0.135},
                                {2 * q, m, -0.135}});
  expect_order(vee, 1, 0, 0, {659.5363141027967, 219.84543803426553}, {219.84543803426547, -659.5363141027965});
  expect_order(vee, 2, 0, 0, 0, 0);
  expect_order(vee, 4, 100.01156319242875, 0, 0, 0);
  expect_order(vee, 6, 0, 0, 0, 0);
}

/// The wrench of all cylinders at crank angle θ from the exact kinematics, cylinder by cylinder in vectors: pistons
/// accelerate along their axes, throws move on circles, and the side force of each rod acts on its wall at the height
/// of the piston.
Eigen::Matrix<double, 6, 1> exact_wrench(const Engine& e, double theta, double speed) {
  const double r = e.crank_radius, rod = r / e.rod_ratio;
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
  for (const Cylinder& c : e.cylinders) {
    const Eigen::Vector3d axis(0, -std::sin(c.bank_angle), std::cos(c.bank_angle)),
        across = Eigen::Vector3d::UnitX().cross(axis);
    const auto height = [&](double t) {
      const double phi = t + c.crank_angle - c.bank_angle;
      return r * std::cos(phi) + std::sqrt(rod * rod - std::pow(r * std::sin(phi), 2));
    };
    const double h = 1e-4,
                 acceleration = (height(theta + h) - 2 * height(theta) + height(theta - h)) / (h * h) * speed * speed;
    const double phi = theta + c.crank_angle - c.bank_angle, s = height(theta);
    const double pin_across = r * std::sin(phi);                 // of the crank pin; the rod connects the piston to it
    const double along_rod = e.oscillating_mass * acceleration;  // axial force of the rod on the piston, no gas
    const double side = -along_rod * pin_across /
        (s - r * std::cos(phi));  // of the rod on the piston, and therefore of the piston on the wall
    const Eigen::Vector3d throw_direction(0, -std::sin(theta + c.crank_angle), std::cos(theta + c.crank_angle));
    const Eigen::Vector3d at(c.position, 0, 0);
    // On the frame: the wall, and the main bearings with the forces of the pin and the throw.
    const Eigen::Vector3d wall = side * across,
                          bearing = -along_rod * axis - side * across +
        (e.rotating_mass * r - e.counterweight) * speed * speed * throw_direction;
    force += wall + bearing;
    moment += (at + s * axis).cross(wall) + at.cross(bearing);
  }
  Eigen::Matrix<double, 6, 1> wrench;
  wrench << force, moment;
  return wrench;
}

TEST(EngineOrders, SumUpToTheForcesOfTheWholeEngineInTime) {
  Engine engine{
      .crank_radius = 0.05, .rod_ratio = 0.28, .oscillating_mass = 0.6, .rotating_mass = 0.8, .counterweight = 0.01};
  engine.cylinders = evenly_firing_cylinders({.kind = EngineLayout::Kind::vee,
                                              .cylinders = 4,
                                              .bank_angle = 70 * degree,
                                              .spacing = 0.1,
                                              .bank_offset = 0.02,
                                              .firing_order = {1, 3, 2, 4}});
  const std::vector<Order> orders = inertia_orders(engine, 24);
  for (const double theta : {0.0, 0.7, 2.1, 3.9, 5.5}) {
    Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
    for (const Order& entry : orders)
      sum += omega * omega * (entry.per_speed_squared * std::polar(1.0, entry.order * theta)).real();
    const auto exact = exact_wrench(engine, theta, omega);
    constexpr double second_difference = 1e-7;  // h²/12 of the fourth derivative, ε/h² of round-off
    for (Eigen::Index i = 0; i < 6; ++i) {
      const double size = i < 3 ? 20000 : 2000;  // N, N m of the whole engine
      EXPECT_NEAR(sum(i), exact(i), second_difference * size) << i;
    }
  }
}

TEST(EngineOrders, CounterweightsOnTheThrowsBalanceTheRotatingMasses) {
  Engine one = engine_of({{0.3, 0, 0.1}});
  one.rotating_mass = 2;
  one.counterweight = 2 * one.crank_radius;
  EXPECT_EQ(inertia(one, 1)(1), 0.0);
  one.oscillating_mass = 0;
  one.counterweight = 0;
  const ComplexVector6 w = inertia(one, 1);  // circles: y leads z by a quarter turn towards −y
  const double force = 2 * 0.045 * omega * omega;
  EXPECT_LE(std::abs(w(2) - force * std::polar(1.0, 0.3)), round_off * force);
  EXPECT_LE(std::abs(w(1) - Complex(0, 1) * w(2)), round_off * force);
}

TEST(EngineOrders, JoinAddsEqualOrders) {
  std::vector<Order> one(1), two(2);
  one[0].order = two[1].order = 2;
  two[0].order = 0.5;
  one[0].fixed(3) = 1;
  two[1].fixed(3) = 2;
  two[1].per_speed_squared(2) = 5;
  const std::vector<Order> all = joined(one, two);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].order, 0.5);
  EXPECT_EQ(all[1].fixed(3), 3.0);
  EXPECT_EQ(all[1].per_speed_squared(2), 5.0);
}

TEST(EngineLayout, ThrowsOfUsualEnginesFollowFromTheirFiring) {
  const auto throws = [](const EngineLayout& layout) {
    std::vector<double> degrees;
    for (const Cylinder& c : evenly_firing_cylinders(layout))
      degrees.push_back(std::remainder(c.crank_angle / degree, 360));
    return degrees;
  };
  using ::testing::ElementsAre;
  const auto near = [](double d) {
    constexpr double round_off_in_degrees = 1e-9;  // a product and a remainder of numbers up to 360
    return ::testing::Truly([d](double x) { return std::abs(std::remainder(x - d, 360)) < round_off_in_degrees; });
  };
  EXPECT_THAT(throws({.cylinders = 4}), ElementsAre(near(0), near(180), near(180), near(0)));
  EXPECT_THAT(throws({.cylinders = 6}), ElementsAre(near(0), near(240), near(120), near(120), near(240), near(0)));
  EXPECT_THAT(throws({.cylinders = 2}), ElementsAre(near(0), near(0)));
  // A flat four, numbered 1 2 on one bank and 3 4 on the other, fires 1 4 3 2: opposite pistons have opposite throws,
  // so primary forces cancel.
  const EngineLayout flat{.kind = EngineLayout::Kind::boxer,
                          .cylinders = 4,
                          .spacing = 0.1,
                          .bank_offset = 0.02,
                          .firing_order = {1, 4, 3, 2}};
  EXPECT_THAT(throws(flat), ElementsAre(near(90), near(270), near(270), near(90)));
  Engine boxer{.crank_radius = 0.04, .rod_ratio = 0.3, .oscillating_mass = 1};
  boxer.cylinders = evenly_firing_cylinders(flat);
  EXPECT_FALSE(check(boxer, "").has_errors());
  EXPECT_EQ(inertia(boxer, 1).head<3>().norm(), 0);
  EXPECT_EQ(inertia(boxer, 2).head<3>().norm(), 0);
  EXPECT_GT(inertia(boxer, 2).tail<3>().norm(), 1);  // the couple of the offset banks remains
}

TEST(EngineLayout, IsCentredOnTheMiddleOfItsCrank) {
  const auto vee = evenly_firing_cylinders({.kind = EngineLayout::Kind::vee,
                                            .cylinders = 6,
                                            .bank_angle = 60 * degree,
                                            .spacing = 0.1,
                                            .bank_offset = 0.02,
                                            .firing_order = {1, 4, 2, 5, 3, 6}});
  constexpr double last_digit = 1e-15;  // a handful of operations on numbers below 1
  const double positions[] = {0.11, 0.01, -0.09, 0.09, -0.01, -0.11};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(vee[i].position, positions[i], last_digit);
    EXPECT_NEAR(vee[i].bank_angle, (i < 3 ? 30 : -30) * degree, last_digit);
  }
}

TEST(Engine, FindingsNameTheError) {
  const auto first = [](const Engine& e) { return foundation::message(check(e, "engine").list().at(0)); };
  Engine engine = engine_of({{0, 0, 0}});
  EXPECT_TRUE(check(engine, "").list().empty());
  EXPECT_THROW((void)gas_orders(engine, {{1, 1}}), foundation::InvalidInput);  // no firing angle
  engine.cylinders[0].firing_angle = 90 * degree;
  EXPECT_THAT(first(engine), HasSubstr("its crank is 90° from top dead centre"));
  engine.cylinders[0].firing_angle = 360 * degree;
  EXPECT_TRUE(check(engine, "").list().empty());
  EXPECT_THROW((void)gas_orders(engine, {{0.3, 1}}), foundation::InvalidInput);
  EXPECT_THROW((void)gas_orders(engine, {{1, 1}, {1, 1}}), foundation::InvalidInput);
  EXPECT_THROW((void)gas_orders(engine, {{1, not_a_number}}), foundation::InvalidInput);
  Engine wrong = engine;
  wrong.rod_ratio = 1.2;
  EXPECT_THAT(first(wrong), HasSubstr("rod_ratio: 1.2"));
  EXPECT_THROW((void)inertia_orders(wrong, 4), foundation::InvalidInput);
  wrong = engine;
  wrong.crank_radius = not_a_number;
  EXPECT_THAT(first(wrong), HasSubstr("crank_radius"));
  wrong = engine;
  wrong.oscillating_mass = -1;
  EXPECT_THAT(first(wrong), HasSubstr("oscillating_mass: -1 kg"));
  wrong = engine;
  wrong.strokes = 3;
  EXPECT_THAT(first(wrong), HasSubstr("2 or 4"));
  wrong.cylinders.clear();
  EXPECT_TRUE(check(wrong, "").has_errors());
}

TEST(EngineLayout, RejectsImpossibleLayouts) {
  EXPECT_THROW((void)evenly_firing_cylinders({.cylinders = 0}), foundation::InvalidInput);
  EXPECT_THROW((void)evenly_firing_cylinders({.cylinders = 7}), foundation::InvalidInput);
  EXPECT_THROW((void)evenly_firing_cylinders({.kind = EngineLayout::Kind::vee, .cylinders = 6}),
               foundation::InvalidInput);
  EXPECT_THROW(
      (void)evenly_firing_cylinders({.kind = EngineLayout::Kind::boxer, .cylinders = 3, .firing_order = {1, 2, 3}}),
      foundation::InvalidInput);
  EXPECT_THROW((void)evenly_firing_cylinders({.cylinders = 4, .firing_order = {1, 3, 3, 2}}), foundation::InvalidInput);
}

}  // namespace engine_orders_test
