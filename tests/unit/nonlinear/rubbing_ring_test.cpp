// SPDX-License-Identifier: BSD-3-Clause
// Friction around and along the wall of a ring.
#include <gmock/gmock.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include "trivet/nonlinear/laws/distance_laws.h"
#include "trivet/nonlinear/laws/rubbing_loop.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace rubbing_ring_test {

using namespace trivet;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using nonlinear::ContactFriction;
using nonlinear::RubbingHarmonics;
using nonlinear::RubbingLoop;

constexpr double pi = std::numbers::pi, omega = 30, longest = pi / 32, play = 1e-3;
constexpr Index harmonics = 3;
const elements::RubbingFriction friction{.coefficient = 0.4, .stiffness = 5e4};

struct Ring {
  Vector3d at_rest = Vector3d::Zero();
  double dissipation = 20, power = 1;

  [[nodiscard]] elements::DistanceForce force() const {
    elements::DistanceForce found{.across = true};
    found.laws.emplace_back(elements::ElasticForce(elements::GapStop{
        .gap_above = play, .stiffness = power > 1 ? 4e6 : 1e5, .power = power, .dissipation = dissipation}));
    return found;
  }
  [[nodiscard]] ContactFriction law() const { return {friction, force(), at_rest}; }
  [[nodiscard]] RubbingLoop loop(const MatrixXd& course, double of_omega = omega, double step = longest,
                                 bool rough = false) const {
    const nonlinear::DistanceHarmonics ring(nonlinear::DistanceAbout(force(), at_rest), (course.rows() - 1) / 2);
    return {law(), course, ring.corners(course), of_omega, step, rough};
  }
  [[nodiscard]] RubbingHarmonics at(const MatrixXd& course, bool with_tangent = false, double of_omega = omega) const {
    return nonlinear::rubbing_harmonics(loop(course, of_omega), course, of_omega, with_tangent);
  }
};

MatrixXd motion(std::initializer_list<double> x, std::initializer_list<double> y, std::initializer_list<double> z) {
  MatrixXd course = MatrixXd::Zero(numerics::coefficient_count(harmonics), 3);
  Index column = 0;
  for (const auto& one : {x, y, z}) {
    Index row = 0;
    for (const double value : one) course(row++, column) = value;
    ++column;
  }
  return course;
}

/// From side to side and along the axis; around all the time; and to and fro on a wall that it never leaves.
struct Case {
  const char* name;
  Ring ring;
  MatrixXd course;

  /// Its mean depends on what happened before.
  [[nodiscard]] bool sticks() const { return std::string(name) == "sticks"; }
};
std::vector<Case> cases() {
  return {{"hits", {}, motion({1e-4, 1.2e-3, 3e-4, 1e-4, -2e-4}, {0, -2e-4, 9e-4, 1e-4, 5e-5}, {0, 4e-4, -2e-4, 1e-4})},
          {"hits and sticks",
           {},
           motion({1e-4, 1.6e-3, 3e-4, 1e-4, -2e-4}, {0, -2e-4, 2e-4, 1e-4, 5e-5}, {0, 1e-4, -2e-4, 1e-4})},
          {"lets go early",
           {Vector3d::Zero(), 60},
           motion({1e-4, 1.2e-3, 3e-4, 1e-4, -2e-4}, {0, -2e-4, 9e-4, 1e-4, 5e-5}, {0, 4e-4, -2e-4, 1e-4})},
          {"whirls", {}, motion({1e-4, 1.6e-3, 0, 1e-4}, {0, 0, 1.7e-3, 1e-4, 5e-5}, {0, 4e-4, -2e-4, 1e-4})},
          {"slides",
           {{1.1e-3, -1.4e-3, 2e-4}},
           motion({-1e-4, 9e-4, 5e-4, 1e-4}, {0, 7e-4, -4e-4, 5e-5, 5e-5}, {0, 5e-4, -2e-4, 1e-4})},
          {"sticks",
           {{1.1e-3, -1.4e-3, 2e-4}},
           motion({1e-4, 4e-4, 3e-4, 1e-4}, {0, 3e-4, -2e-4, 5e-5, 5e-5}, {0, 5e-4, -2e-4, 1e-4})},
          {"is Hertz's",
           {Vector3d::Zero(), 0, 1.5},
           motion({1e-4, 1.6e-3, 0, 1e-4}, {0, 0, 1.7e-3, 1e-4, 5e-5}, {0, 4e-4, -2e-4, 1e-4})}};
}

/// Forces by very small steps: springs between the wall and a place on it, which moves so that the friction keeps its
/// limit. The spring around the ring has the energy k (radius × angle)²/2.
MatrixXd by_small_steps(const Ring& ring, const MatrixXd& course, int steps) {
  const Index count = course.rows(), H = (count - 1) / 2;
  const double at_rest = ring.at_rest.head<2>().norm(), radius = at_rest > play ? at_rest : play;
  MatrixXd sum = MatrixXd::Zero(count, 3), slope(count, 3);
  for (Index j = 0; j < 3; ++j) slope.col(j) = numerics::phase_derivative(course.col(j));
  Vector2d stretch = Vector2d::Zero(), before = Vector2d::Zero();  // angle and way along the axis
  for (int i = 0; i <= 3 * steps; ++i) {
    const Eigen::RowVectorXd row = numerics::fourier_row(H, 2 * pi * i / steps);
    const Vector3d place = ring.at_rest + (row * course).transpose(), rate = omega * (row * slope).transpose();
    const double distance = place.head<2>().norm(), angle = std::atan2(place.y(), place.x());
    const Vector3d outwards(place.x() / distance, place.y() / distance, 0);
    const elements::SpatialForce contact = elements::force_in_motion(ring.force(), place, rate);
    const double limit = friction.coefficient * contact.force.norm();
    const Vector2d here(angle, place.z());
    if (i > 0) stretch += Vector2d(std::remainder(here.x() - before.x(), 2 * pi), here.y() - before.y());
    before = here;
    Vector2d force = friction.stiffness * Vector2d(radius * radius / distance * stretch.x(), stretch.y());
    if (const double size = force.norm(); size > limit) {
      force *= limit / size;
      stretch *= limit / size;
    }
    const Vector3d on_pin(-outwards.y() * force.x(), outwards.x() * force.x(), force.y());
    if (i > 2 * steps) sum += 2.0 / steps * row.transpose() * on_pin.transpose();
  }
  sum.row(0) /= 2;
  return sum - course * ring.law().own_stiffness();
}

TEST(RubbingRing, IsWhatManySmallStepsGive) {
  constexpr int steps = 200000;
  constexpr double of_turning = 3e-4;  // of the force; of both kinds of steps
  for (const Case& one : cases()) {
    ASSERT_EQ(one.ring.loop(one.course).always_sticks(), one.sticks()) << one.name;
    if (one.sticks()) continue;
    const MatrixXd expected = by_small_steps(one.ring, one.course, steps), found = one.ring.at(one.course).force;
    EXPECT_NEAR((found - expected).norm(), 0, of_turning * expected.norm()) << one.name;
  }
}

/// So that they can be removed by steps of twice the length.
TEST(RubbingRing, HasErrorsOfTheSquareOfItsSteps) {
  constexpr double step = pi / 16, exact = pi / 2048, of_ratio = 0.5, removed = 0.15;
  for (const Case& one : cases()) {
    // Where a contact slips briefly, the instants at which it begins to cut the steps.
    if (one.sticks() || std::string(one.name) == "hits and sticks") continue;
    const auto force = [&](double longest_step, bool rough) {
      return nonlinear::rubbing_harmonics(one.ring.loop(one.course, omega, longest_step, rough), one.course, omega,
                                          false)
          .force;
    };
    const MatrixXd expected = force(exact, false), fine = force(step, false), rough = force(step, true);
    EXPECT_NEAR((rough - expected).norm() / (fine - expected).norm(), 4, of_ratio) << one.name;
    EXPECT_LT((fine + (fine - rough) / 3 - expected).norm(), removed * (fine - expected).norm()) << one.name;
  }
}

/// Pressed at rest and lifted all the time, and never touched: the linear machine's springs alone are taken off.
TEST(RubbingRing, WithoutContactHasNoFriction) {
  const MatrixXd small = motion({0, 1e-4}, {0, 0, 1e-4}, {0, 1e-4});
  const RubbingHarmonics never = Ring{}.at(small, true);
  EXPECT_EQ(never.force.norm(), 0);
  MatrixXd lifted = small;
  const Ring ring{.at_rest = {1.2e-3, 0, 0}};
  lifted(0, 0) = -1.2e-3;
  const RubbingHarmonics found = ring.at(lifted, true);
  const Eigen::Matrix3d own = ring.law().own_stiffness();
  EXPECT_GT(own.norm(), 0);
  EXPECT_NEAR((found.force + lifted * own).norm(), 0, 1e-15);
  for (Index a = 0; a < 3; ++a)
    for (Index b = 0; b < 3; ++b)
      if (const double k = own(a, b); k != 0) {
        EXPECT_EQ(found.tangent[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)],
                  -k * MatrixXd::Identity(small.rows(), small.rows()));
      }
}

TEST(RubbingRing, HasTheDerivativesOfItsForces) {
  constexpr double h = 1e-9, accurate = 3e-4;  // nodes move with the instants, and so do the errors of their steps
  for (const Case& one : cases()) {
    const RubbingHarmonics found = one.ring.at(one.course, true);
    double largest = 0;
    for (const auto& row : found.tangent)
      for (const MatrixXd& block : row) largest = std::max(largest, block.norm());
    for (Index b = 0; b < 3; ++b)
      for (Index c = 0; c < one.course.rows(); ++c) {
        MatrixXd more = one.course, less = one.course;
        more(c, b) += h;
        less(c, b) -= h;
        const MatrixXd slope = (one.ring.at(more).force - one.ring.at(less).force) / (2 * h);
        for (Index a = 0; a < 3; ++a)
          EXPECT_NEAR(
              (found.tangent[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)].col(c) - slope.col(a)).norm(), 0,
              accurate * largest)
              << one.name << " " << a << b << c;
      }
    const double step = 1e-5 * omega;
    const MatrixXd by_omega =
        (one.ring.at(one.course, false, omega + step).force - one.ring.at(one.course, false, omega - step).force) /
        (2 * step);
    EXPECT_NEAR((found.by_omega - by_omega).norm(), 0, accurate * found.force.norm() / omega) << one.name;
  }
}

/// Springs around a ring keep their energy, also where the wall yields: no work over a period.
TEST(RubbingRing, ThatSticksTakesNoEnergy) {
  const Ring ring{.at_rest = {2.1e-3, -2.4e-3, 0}};
  const MatrixXd course = motion({0, 1e-4, 3e-4, 1e-4}, {0, 3e-4, -2e-4, 5e-5, 5e-5}, {0, 1e-4, -2e-4, 1e-4});
  ASSERT_TRUE(ring.loop(course).always_sticks());
  const MatrixXd force = ring.at(course).force;
  double work = 0, turned_over = 0;
  for (Index j = 0; j < 3; ++j) {
    const Eigen::VectorXd rate = numerics::phase_derivative(course.col(j));
    work += pi * force.col(j).tail(force.rows() - 1).dot(rate.tail(rate.size() - 1));
    turned_over += pi * force.col(j).norm() * rate.norm();
  }
  // The linear machine's springs, which are taken off, do no work either; harmonics above the third of the motion do
  // none.
  constexpr double of_quadrature = 1e-9;
  EXPECT_NEAR(work, 0, of_quadrature * turned_over);
}

TEST(RubbingRing, IsTheSameInTurnedDirections) {
  constexpr double angle = 2.3;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  for (const Case& one : cases()) {
    Ring turned = one.ring;
    turned.at_rest = turn * one.ring.at_rest;
    const MatrixXd force = one.ring.at(one.course).force, other = turned.at(one.course * turn.transpose()).force;
    EXPECT_NEAR((force * turn.transpose() - other).norm(), 0, 1e-8 * force.norm()) << one.name;
  }
}

/// A variation e^{iμφ}, with μ = 1/2, in the motion of twice the period: harmonic k of the period is 2 k there.
TEST(RubbingRing, HasVariationsThatAreTangentsOfTwiceThePeriod) {
  constexpr Index kept = 8;
  for (const Case& one : cases()) {
    if (one.sticks()) continue;  // in twice the period its springs may stick elsewhere
    const nonlinear::RubbingVariation found = nonlinear::rubbing_variation(one.ring.loop(one.course), omega, 0.5, kept);
    MatrixXd twice = MatrixXd::Zero(numerics::coefficient_count(2 * kept + 1), 3);
    for (Index k = 1; k <= harmonics; ++k) twice.middleRows(4 * k - 1, 2) = one.course.middleRows(2 * k - 1, 2);
    twice.row(0) = one.course.row(0);
    const RubbingHarmonics real =
        nonlinear::rubbing_harmonics(one.ring.loop(twice, omega / 2, longest / 2), twice, omega / 2, true);
    constexpr double of_quadrature = 3e-4;
    double largest = 0;
    for (const auto& row : found)
      for (const auto& block : row) largest = std::max(largest, block.norm());
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) {
        // Complex amplitude a − i b at the order 2k + 1 by that at 2l + 1: the mean of both real columns.
        const auto of_order = [&](Index to, Index from) {
          const auto& t = real.tangent[a][b];
          const Index r = 2 * (2 * to + 1) - 1, c = 2 * (2 * from + 1) - 1;
          return std::complex<double>(t(r, c) + t(r + 1, c + 1), t(r, c + 1) - t(r + 1, c)) / 2.0;
        };
        for (Index k = 0; k < 3; ++k)
          for (Index l = 0; l < 3; ++l)
            EXPECT_NEAR(std::abs(found[a][b](kept + k, kept + l) - of_order(k, l)), 0, of_quadrature * largest)
                << one.name << " " << a << b << " " << k << l;
      }
  }
}

}  // namespace rubbing_ring_test
