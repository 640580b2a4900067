// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/rubbing_loop.h"

#include <gmock/gmock.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "trivet/nonlinear/laws/law_harmonics.h"
#include "trivet/numerics/periodic/fourier_basis.h"
#include "trivet/numerics/periodic/level_crossings.h"

namespace rubbing_loop_test {

using namespace trivet;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using elements::GapStop;
using nonlinear::ContactFriction;
using nonlinear::RubbingLoop;

constexpr double pi = std::numbers::pi, omega = 30, longest = pi / 32;
constexpr Index harmonics = 3;

/// Contact at rest by `pressed`, or a gap of as much if that is negative.
ContactFriction rubbing(double pressed, double dissipation = 0, double power = 1) {
  GapStop stop{.gap_above = 1e-3, .stiffness = power > 1 ? 4e6 : 1e5, .power = power, .dissipation = dissipation};
  return {{.coefficient = 0.4, .stiffness = 5e4}, {stop}, 1e-3 + pressed};
}

std::vector<double> corners(const ContactFriction&, const MatrixXd& course, double pressed) {
  MatrixXd samples(256, course.rows());
  for (Index n = 0; n < samples.rows(); ++n)
    samples.row(n) = numerics::fourier_row((course.rows() - 1) / 2, 2 * pi * static_cast<double>(n) / 256);
  return numerics::level_crossings(course.col(0), {-pressed}, samples);
}

RubbingLoop loop(const ContactFriction& law, const MatrixXd& course, double pressed, double of_omega = omega) {
  return {law, course, corners(law, course, pressed), of_omega, longest};
}

/// The contact opens and closes, and the deflections across turn.
MatrixXd motion() {
  MatrixXd course = MatrixXd::Zero(numerics::coefficient_count(harmonics), 3);
  course.col(0) << 1e-4, 6e-4, 1e-4, 5e-5, -8e-5, 2e-5, 3e-5;
  course.col(1) << 0, 1e-3, 4e-4, 1e-4, 2e-4, -5e-5, 8e-5;
  course.col(2) << 2e-4, -3e-4, 7e-4, -1e-4, 1e-4, 3e-5, 4e-5;
  return course;
}

/// Forces by very small steps, each of which brings a force beyond the limit back along itself.
MatrixXd by_small_steps(const ContactFriction& law, const MatrixXd& course, int steps) {
  const Index count = course.rows(), H = (count - 1) / 2;
  MatrixXd sum = MatrixXd::Zero(count, 2), slope(count, 3);
  for (Index j = 0; j < 3; ++j) slope.col(j) = numerics::phase_derivative(course.col(j));
  Vector2d force = Vector2d::Zero(), before = course.row(0).tail<2>().transpose();
  for (int i = 0; i <= 3 * steps; ++i) {
    const Eigen::RowVectorXd row = numerics::fourier_row(H, 2 * pi * i / steps);
    const Eigen::RowVector3d value = row * course;
    const double limit = law.limit(value(0), omega * row.dot(slope.col(0))).value;
    const Vector2d across = value.tail<2>().transpose();
    force += law.law().stiffness * (across - before);
    if (force.norm() > limit) force *= limit / force.norm();
    before = across;
    if (i > 2 * steps) sum += 2.0 / steps * row.transpose() * force.transpose();
  }
  sum.row(0) /= 2;
  return sum - law.own_stiffness()(1, 1) * course.rightCols<2>();
}

TEST(Slip, HasTheDerivativesOfItsForce) {
  const Vector2d start(3, -4), travel(2e-5, 5e-5);
  constexpr double k = 5e4, before = 5, limit = 5.5, h = 1e-6, accurate = 1e-6;  // of differences
  const auto at = [&](const Vector2d& from, const Vector2d& by, double low, double high) {
    return elements::slip(k, from, by, low, high);
  };
  for (const double size : {1.0, 1e-3, 30.0}) {
    const Vector2d by = size * travel;
    const elements::Slip found = at(start, by, before, limit);
    EXPECT_NEAR(found.force.norm(), limit, 1e-14 * limit);
    for (Index a = 0; a < 2; ++a) {
      const Vector2d step = h * Vector2d::Unit(a);
      const Vector2d by_start =
          (at(start + step, by, before, limit).force - at(start - step, by, before, limit).force) / (2 * h);
      const double small = h * by.norm();
      const Vector2d move = small * Vector2d::Unit(a);
      const Vector2d by_travel =
          (at(start, by + move, before, limit).force - at(start, by - move, before, limit).force) / (2 * small);
      EXPECT_NEAR((found.by_start.col(a) - by_start).norm(), 0, accurate);
      EXPECT_NEAR((found.by_travel.col(a) - by_travel).norm(), 0, accurate * found.by_travel.norm() + accurate * k);
    }
    EXPECT_NEAR(
        (found.by_limit - (at(start, by, before, limit + h).force - at(start, by, before, limit - h).force) / (2 * h))
            .norm(),
        0, accurate);
    EXPECT_NEAR((found.by_limit_before -
                 (at(start, by, before + h, limit).force - at(start, by, before - h, limit).force) / (2 * h))
                    .norm(),
                0, accurate);
  }
}

TEST(Slip, OfAConstantLimitIsThatOfManySmallTravels) {
  const Vector2d start(3, -4), travel(2e-5, 5e-5);
  constexpr double k = 5e4, limit = 5;
  constexpr int pieces = 20000;
  Vector2d force = start;
  for (int i = 0; i < pieces; ++i) {
    force += k / pieces * travel;
    force *= limit / force.norm();
  }
  constexpr double of_small_steps = 1e-4;
  EXPECT_NEAR((elements::slip(k, start, travel, limit, limit).force - force).norm(), 0, of_small_steps * limit);
}

TEST(RubbingLoop, UnderConstantPressureIsASlider) {
  constexpr double pressed = 2e-4;
  const ContactFriction law = rubbing(pressed);
  MatrixXd course = motion();
  course.col(0).setZero();
  course.col(2).setZero();
  const RubbingLoop found = loop(law, course, pressed);
  const nonlinear::RubbingHarmonics harmonic = nonlinear::rubbing_harmonics(found, course, omega, true);
  const elements::ScalarLaws slider = {elements::HystereticForce(elements::Slider{5e4, law.limit(0, 0).value, 0})};
  const nonlinear::LawHarmonics exact(nonlinear::DeviationLaw(slider, 0, {5e4, 0}), harmonics);
  const nonlinear::ForceHarmonics expected = exact.at(course.col(1), omega);
  constexpr double of_quadrature = 1e-9;
  EXPECT_NEAR((harmonic.force.col(1) - expected.force).norm(), 0, of_quadrature * expected.force.norm());
  EXPECT_NEAR((harmonic.tangent[1][1] - expected.tangent).norm(), 0, of_quadrature * expected.tangent.norm());
  EXPECT_EQ(harmonic.force.col(2).norm(), 0);
}

TEST(RubbingLoop, IsWhatManySmallStepsGive) {
  constexpr int steps = 200000;
  constexpr double of_turning = 1e-4;  // of the force; both fall with the square of the steps
  for (const double pressed : {-2e-4, 2e-4, 8e-4})
    for (const double dissipation : {0.0, 20.0}) {
      const ContactFriction law = rubbing(pressed, dissipation);
      const MatrixXd course = motion(), expected = by_small_steps(law, course, steps),
                     found = nonlinear::rubbing_harmonics(loop(law, course, pressed), course, omega, false)
                                 .force.rightCols<2>();
      EXPECT_NEAR((found - expected).norm(), 0, of_turning * expected.norm()) << pressed << " " << dissipation;
    }
}

/// So that they can be removed by steps of twice the length.
TEST(RubbingLoop, HasErrorsOfTheSquareOfItsSteps) {
  constexpr double step = pi / 16, exact = pi / 2048, of_ratio = 0.4, removed = 0.1;
  for (const double pressed : {-2e-4, 2e-4, 8e-4}) {
    const ContactFriction law = rubbing(pressed, 20);
    const MatrixXd course = motion();
    const auto force = [&](double longest_step, bool rough) {
      const RubbingLoop one(law, course, corners(law, course, pressed), omega, longest_step, rough);
      return nonlinear::rubbing_harmonics(one, course, omega, false).force;
    };
    const MatrixXd expected = force(exact, false), fine = force(step, false), rough = force(step, true);
    EXPECT_NEAR((rough - expected).norm() / (fine - expected).norm(), 4, of_ratio) << pressed;
    EXPECT_LT((fine + (fine - rough) / 3 - expected).norm(), removed * (fine - expected).norm()) << pressed;
  }
}

TEST(RubbingLoop, HasTheDerivativesOfItsForces) {
  constexpr double h = 1e-9, accurate = 2e-4;  // nodes move with the instants, and so do the errors of their steps
  for (const double pressed : {-2e-4, 2e-4, 8e-4})
    for (const double power : {1.0, 1.5}) {
      const ContactFriction law = rubbing(pressed, 20, power);
      const MatrixXd course = motion();
      const auto forces = [&](const MatrixXd& of, double at) {
        return nonlinear::rubbing_harmonics(loop(law, of, pressed, at), of, at, false).force;
      };
      const nonlinear::RubbingHarmonics found =
          nonlinear::rubbing_harmonics(loop(law, course, pressed), course, omega, true);
      double largest = 0;
      for (const auto& row : found.tangent)
        for (const MatrixXd& one : row) largest = std::max(largest, one.norm());
      for (Index b = 0; b < 3; ++b)
        for (Index c = 0; c < course.rows(); ++c) {
          MatrixXd more = course, less = course;
          more(c, b) += h;
          less(c, b) -= h;
          const MatrixXd slope = (forces(more, omega) - forces(less, omega)) / (2 * h);
          for (Index a = 1; a < 3; ++a)
            EXPECT_NEAR((found.tangent[a][b].col(c) - slope.col(a)).norm(), 0, accurate * largest)
                << pressed << " " << power << " " << a << b << c;
        }
      const double step = 1e-5 * omega;
      const MatrixXd by_omega = (forces(course, omega + step) - forces(course, omega - step)) / (2 * step);
      EXPECT_NEAR((found.by_omega - by_omega).norm(), 0, accurate * by_omega.norm());
    }
}

/// A stop that is met quickly sticks at once, to the place at which it closed.
TEST(RubbingLoop, HasTheDerivativesOfSticksFromItsClosing) {
  constexpr double pressed = -2e-4, h = 1e-9, accurate = 2e-4;
  const ContactFriction law = rubbing(pressed, 20);
  MatrixXd course = motion();
  course.rightCols<2>() *= 0.2;
  const RubbingLoop found = loop(law, course, pressed);
  const std::vector<RubbingLoop::Change> changes = found.changes();
  ASSERT_TRUE(std::ranges::any_of(changes, [](const RubbingLoop::Change& change) {
    return change.before == RubbingLoop::State::open && change.after == RubbingLoop::State::sticks;
  }));
  const nonlinear::RubbingHarmonics harmonic = nonlinear::rubbing_harmonics(found, course, omega, true);
  double largest = 0;
  for (const auto& row : harmonic.tangent)
    for (const MatrixXd& one : row) largest = std::max(largest, one.norm());
  for (Index b = 0; b < 3; ++b)
    for (Index c = 0; c < course.rows(); ++c) {
      MatrixXd more = course, less = course;
      more(c, b) += h;
      less(c, b) -= h;
      const MatrixXd slope = (nonlinear::rubbing_harmonics(loop(law, more, pressed), more, omega, false).force -
                              nonlinear::rubbing_harmonics(loop(law, less, pressed), less, omega, false).force) /
          (2 * h);
      for (Index a = 1; a < 3; ++a)
        EXPECT_NEAR((harmonic.tangent[a][b].col(c) - slope.col(a)).norm(), 0, accurate * largest) << a << b << c;
    }
}

TEST(RubbingLoop, SticksFarthestBelowItsLimits) {
  constexpr double pressed = 1.4e-3, h = 1e-9, of_differences = 5e-4;
  const ContactFriction law = rubbing(pressed);
  const double k = law.law().stiffness;
  const MatrixXd course = 0.5 * motion();
  const RubbingLoop found = loop(law, course, pressed);
  ASSERT_TRUE(found.always_sticks());
  for (const RubbingLoop::Point& point : found.points()) EXPECT_LT(point.force.norm(), point.limit.value);
  const nonlinear::RubbingHarmonics harmonic = nonlinear::rubbing_harmonics(found, course, omega, true);
  for (Index b = 0; b < 3; ++b)
    for (Index c = 0; c < course.rows(); ++c) {
      MatrixXd more = course, less = course;
      more(c, b) += h;
      less(c, b) -= h;
      const MatrixXd slope = (nonlinear::rubbing_harmonics(loop(law, more, pressed), more, omega, false).force -
                              nonlinear::rubbing_harmonics(loop(law, less, pressed), less, omega, false).force) /
          (2 * h);
      for (Index a = 1; a < 3; ++a)
        EXPECT_NEAR((harmonic.tangent[a][b].col(c) - slope.col(a)).norm(), 0, of_differences * k) << a << b << c;
    }
}

/// As a motion grows, it begins to slip with the force at which it stuck.
TEST(RubbingLoop, BeginsToSlipWithoutAJump) {
  constexpr double pressed = 8e-4;
  const ContactFriction law = rubbing(pressed);
  double low = 0.3, high = 0.8;
  const auto at = [&](double share) { return loop(law, share * motion(), pressed); };
  ASSERT_TRUE(at(low).always_sticks());
  ASSERT_FALSE(at(high).always_sticks());
  for (int i = 0; i < 30; ++i) (at((low + high) / 2).always_sticks() ? low : high) = (low + high) / 2;
  const MatrixXd before = nonlinear::rubbing_harmonics(at(low), low * motion(), omega, false).force,
                 after = nonlinear::rubbing_harmonics(at(high), high * motion(), omega, false).force;
  constexpr double of_nodes = 1e-2;  // between two of them it slips a little earlier
  EXPECT_NEAR((after - before).norm(), 0, of_nodes * before.norm());
}

TEST(DeepestPlace, OfDiscs) {
  using nonlinear::Disc;
  EXPECT_EQ(nonlinear::deepest_place({Disc{{1, 2}, 2}}).place, Vector2d(1, 2));
  const auto two = nonlinear::deepest_place({Disc{{0, 0}, 3}, Disc{{4, 0}, 2}, Disc{{2, 0}, 9}});
  EXPECT_NEAR((two.place - Vector2d(2.5, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR(two.beyond, -0.5, 1e-12);
  const auto three = nonlinear::deepest_place({Disc{{1, 0}, 1}, Disc{{-1, 0}, 1}, Disc{{0, 2}, 1}});
  EXPECT_NEAR((three.place - Vector2d(0, 0.75)).norm(), 0, 1e-12);
  EXPECT_NEAR(three.beyond, 0.25, 1e-12);
}

/// As deep in all ellipses that hold it, by its definition; its derivatives by differences.
TEST(DeepestPlace, OfEllipses) {
  using nonlinear::DeepestPlace;
  using nonlinear::Disc;
  constexpr double h = 1e-7, of_differences = 1e-6, exact = 1e-11;
  for (const double hoop : {0.2, 0.7, 1.3, 1.9, 2.6}) {
    const std::vector<Disc> discs = {{{0, 0}, 3, hoop}, {{3, 1}, 2, 1.1}, {{1, 2.5}, 1.5, 0.9}, {{1, 1}, 9, hoop}};
    const DeepestPlace found = nonlinear::deepest_place(discs);
    ASSERT_TRUE(std::isfinite(found.beyond)) << hoop;
    double deepest = -1e9;
    for (const Disc& disc : discs) {
      const Vector2d away = found.place - disc.center;
      deepest = std::max(deepest, Vector2d(disc.hoop * away.x(), away.y()).norm() - disc.radius);
    }
    EXPECT_NEAR(deepest, found.beyond, exact) << hoop;
    for (const DeepestPlace::Held& held : found.held) {
      const auto moved = [&](double by, const auto& change) {
        std::vector<Disc> other = discs;
        change(other[held.disc], by);
        return nonlinear::deepest_place(other).place;
      };
      const auto slope = [&](const auto& change) { return Vector2d((moved(h, change) - moved(-h, change)) / (2 * h)); };
      EXPECT_NEAR((slope([](Disc& disc, double by) { disc.center.x() += by; }) - held.by_center.col(0)).norm(), 0,
                  of_differences);
      EXPECT_NEAR((slope([](Disc& disc, double by) { disc.center.y() += by; }) - held.by_center.col(1)).norm(), 0,
                  of_differences);
      EXPECT_NEAR((slope([](Disc& disc, double by) { disc.radius += by; }) - held.by_radius).norm(), 0, of_differences);
      EXPECT_NEAR((slope([](Disc& disc, double by) { disc.hoop += by; }) - held.by_hoop).norm(), 0, of_differences);
    }
  }
}

TEST(RubbingLoop, IsTheSameInTurnedDirections) {
  constexpr double pressed = 2e-4, angle = 0.7;
  const ContactFriction law = rubbing(pressed);
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  const MatrixXd course = motion();
  MatrixXd turned = course;
  turned.rightCols<2>() = course.rightCols<2>() * turn.transpose();
  const MatrixXd one = nonlinear::rubbing_harmonics(loop(law, course, pressed), course, omega, false).force,
                 other = nonlinear::rubbing_harmonics(loop(law, turned, pressed), turned, omega, false).force;
  EXPECT_NEAR((one.rightCols<2>() * turn.transpose() - other.rightCols<2>()).norm(), 0, 1e-10 * one.norm());
}

/// A variation e^{iμφ}, with μ = 1/2, in the motion of twice the period: harmonic k of the period is 2 k there.
TEST(RubbingVariation, IsTheTangentOfTwiceThePeriod) {
  constexpr Index kept = 8;
  for (const double pressed : {-2e-4, 8e-4}) {
    const ContactFriction law = rubbing(pressed, 20);
    const MatrixXd course = motion();
    const nonlinear::RubbingVariation found =
        nonlinear::rubbing_variation(loop(law, course, pressed), omega, 0.5, kept);
    MatrixXd twice = MatrixXd::Zero(numerics::coefficient_count(2 * kept + 1), 3);
    for (Index k = 1; k <= harmonics; ++k) twice.middleRows(4 * k - 1, 2) = course.middleRows(2 * k - 1, 2);
    twice.row(0) = course.row(0);
    const RubbingLoop longer(law, twice, corners(law, twice, pressed), omega / 2, longest / 2);
    const nonlinear::RubbingHarmonics real = nonlinear::rubbing_harmonics(longer, twice, omega / 2, true);
    constexpr double of_quadrature = 2e-4;
    for (std::size_t a = 1; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) {
        // Complex amplitude a − i b at the order 2k + 1 by that at 2l + 1: the mean of both real columns.
        const auto of_order = [&](Index to, Index from) {
          const auto& t = real.tangent[a][b];
          const Index r = 2 * (2 * to + 1) - 1, c = 2 * (2 * from + 1) - 1;
          return std::complex<double>(t(r, c) + t(r + 1, c + 1), t(r, c + 1) - t(r + 1, c)) / 2.0;
        };
        double largest = 0;
        for (const auto& one : found[a]) largest = std::max(largest, one.norm());
        for (Index k = 0; k < 3; ++k)
          for (Index l = 0; l < 3; ++l)
            EXPECT_NEAR(std::abs(found[a][b](kept + k, kept + l) - of_order(k, l)), 0, of_quadrature * largest)
                << pressed << " " << a << b << " " << k << l;
      }
  }
}

}  // namespace rubbing_loop_test
