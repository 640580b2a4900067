// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <random>

#include "support/projects.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/balance/harmonic_balance.h"
#include "trivet/nonlinear/branch/stable_motions.h"
#include "trivet/nonlinear/branch/steady_branch.h"

/// All curves that are followed, with the detached ones, against motions that Newton's method finds from dense starts
/// at fixed frequencies. Both solve the same equations; the search is what is compared.
namespace detached_motions_test {

using namespace trivet;
using Eigen::Index;
using Eigen::VectorXd;

struct RandomMachine {
  std::string text;
  std::vector<std::string> laws;
  double from, to;  ///< of the band [rad/s]
};

RandomMachine random_machine(std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return std::exp(std::uniform_real_distribution<double>(std::log(low), std::log(high))(random));
  };
  const auto chance = [&](double share) { return std::uniform_real_distribution<double>(0, 1)(random) < share; };
  const int count = std::uniform_int_distribution<int>(1, 3)(random);
  const double frequency = between(10, 200), travel = between(1e-4, 1e-2);
  RandomMachine machine;
  std::vector<double> masses, springs, dashpots;
  for (int i = 0; i <= count; ++i) {
    const double mass = between(1, 30), stiffness = mass * frequency * frequency * between(0.3, 3);
    if (i < count) masses.push_back(mass);
    springs.push_back(stiffness);
    dashpots.push_back(2 * between(0.005, 0.1) * std::sqrt(stiffness * mass));
    if (i > 0 && !chance(0.4)) continue;
    const std::string path = fmt::format("elements.k{}.laws.x=", i + 1);
    const double kind = std::uniform_real_distribution<double>(0, 3)(random);
    if (kind < 1)
      machine.laws.push_back(path +
                             fmt::format("{{cubic={:.6g}, quadratic={:.6g}}}", stiffness / (travel * travel),
                                         chance(0.4) ? 0.8 * stiffness / travel : 0));
    else if (kind < 2)
      machine.laws.push_back(path +
                             fmt::format("{{gap_stop={{gaps=[{:.6g}, {:.6g}], stiffness={:.6g}}}}}", travel,
                                         chance(0.5) ? travel : 3 * travel, between(1, 20) * stiffness));
    else
      machine.laws.push_back(path +
                             fmt::format("{{friction={{stiffness={:.6g}, slip={:.6g}}}}}", between(0.3, 3) * stiffness,
                                         0.3 * stiffness * travel));
  }
  const double force = springs[0] * travel * between(0.03, 1);
  machine.text = test::chain(masses, springs, dashpots) +
      fmt::format("\n[excitations.F]\ntype = \"harmonic\"\non = \"m1\"\nat = [0, 0, 0]\nforce = [{:.6g}, 0, 0]\n",
                  force);
  machine.from = 0.2 * frequency;
  machine.to = 4 * frequency;
  return machine;
}

/// Motions at a frequency from many starts.
std::vector<Eigen::MatrixXd> dense_search(const model::System& given, double omega, Index harmonics, int starts,
                                          std::mt19937& random) {
  const nonlinear::References references = nonlinear::tangents_at_rest(given);
  const model::System system = nonlinear::with_references(given, references);
  const assembly::Assembled assembled = assembly::assemble(system);
  const std::vector<nonlinear::Deflection> deflections =
      nonlinear::nonlinear_deflections(system, assembled, references);
  const nonlinear::CondensedMachine machine(assembled, deflections,
                                            nonlinear::periodic_excitation(system, assembled, {}));
  const nonlinear::HarmonicBalance balance(machine, deflections, harmonics);
  const double size = balance.linear_motion({omega, 1}).cwiseAbs().maxCoeff();
  const numerics::Branch branch(
      [&](const VectorXd& unknowns, double parameter, numerics::Equations& equations) {
        balance.evaluate(unknowns, {parameter, 1}, nonlinear::Parameter::frequency, equations);
      },
      VectorXd::Constant(balance.size(), 1e-3 * size), omega);
  std::vector<Eigen::MatrixXd> found;
  std::normal_distribution<double> normal;
  for (int s = 0; s < starts; ++s) {
    const double scale = size * std::exp(std::uniform_real_distribution<double>(-3, 5)(random));
    VectorXd guess(balance.size());
    for (Index i = 0; i < guess.size(); ++i) {
      const Index within = i % balance.coefficients();
      guess(i) = scale * normal(random) * (within == 0 ? 0.3 : within <= 2 ? 1 : 0.1);
    }
    const auto motion = branch.start(guess, omega);
    if (!motion) continue;
    const Eigen::MatrixXd coefficients = balance.motion(motion->unknowns);
    if (std::ranges::none_of(found, [&](const Eigen::MatrixXd& other) {
          return (other - coefficients).norm() < 1e-4 * coefficients.norm();
        }))
      found.push_back(coefficients);
  }
  return found;
}

TEST(DetachedMotions, DenseStartsFindNoOthersOnRandomMachines) {
  const bool is_long = std::getenv("TRIVET_LONG_TESTS");
  const int machines = is_long ? 1000 : 25, starts = is_long ? 300 : 60;
  std::mt19937 random(7);
  int ended = 0, with_detached = 0, missed = 0, motions = 0;
  for (int i = 0; i < machines; ++i) {
    const RandomMachine drawn = random_machine(random);
    const model::System system = test::project(drawn.text, drawn.laws).base().system;
    nonlinear::SteadyOptions options{.from = drawn.from, .to = drawn.to, .harmonics = 5};
    options.detached = true;
    for (int k = 1; k <= 5; ++k) options.at.push_back(drawn.from + (drawn.to - drawn.from) * k / 6.1);
    const nonlinear::SteadyBranch branch = nonlinear::steady_branch(system, options);
    if (!branch.ended.empty()) ++ended;
    if (!branch.further_ones(nonlinear::SteadyBranch::Found::detached).empty()) ++with_detached;
    std::vector<nonlinear::SteadyPoint> known = branch.at;
    for (const nonlinear::SteadyBranch& detached : branch.further)
      known.insert(known.end(), detached.at.begin(), detached.at.end());
    bool misses = false;
    for (const double omega : options.at)
      for (const Eigen::MatrixXd& motion : dense_search(system, omega, options.harmonics, starts, random)) {
        ++motions;
        const bool is_known = std::ranges::any_of(known, [&](const nonlinear::SteadyPoint& point) {
          constexpr double same = 1e-3;
          return std::abs(point.angular_frequency - omega) < 1e-9 * omega &&
              (point.deflections - motion).norm() < same * motion.norm();
        });
        if (!is_known && !misses && is_long) {
          std::printf("machine %d misses a motion at %.9g rad/s (ended: %s)\n%s", i, omega, branch.ended.c_str(),
                      drawn.text.c_str());
          for (const std::string& law : drawn.laws) std::printf("%s\n", law.c_str());
        }
        misses = misses || !is_known;
      }
    if (misses) ++missed;
  }
  std::printf("%d machines: %d ended, %d with detached curves, %d miss one of %d motions\n", machines, ended,
              with_detached, missed, motions);
  EXPECT_LE(ended, machines / 100);
  EXPECT_LE(missed, machines / 100);
  EXPECT_GT(motions, 5 * machines);
}

/// The nonlinear tuned vibration absorber of a hardening machine: in a range of forces a closed curve of large motions
/// lies beside the main one. [Detroux, Habib, Masset, Kerschen, Mech. Syst. Signal Process. 60–61 (2015)]
TEST(DetachedMotions, AbsorberHasAnIsolaInARangeOfForces) {
  const auto curves = [](double force, double from = 0.4) {
    const project::Project project = test::project(
        R"(trivet = 1
[bodies.m1]
mass = 1
free = ["x"]
[bodies.m2]
mass = 0.05
free = ["x"]
[elements.k1]
type = "three_springs"
on = "m1"
at = [0, 0, 0]
translation = [1, 0, 0]
damping = {translation = [0.002, 0, 0]}
laws.x = {cubic = 1}
[elements.k2]
type = "three_springs"
on = "m2"
from = "m1"
at = [0, 0, 0]
translation = [0.0454, 0, 0]
damping = {translation = [0.0128, 0, 0]}
laws.x = {cubic = 0.0042}
[excitations.F]
type = "harmonic"
on = "m1"
at = [0, 0, 0]
force = [)" +
        std::to_string(force) + ", 0, 0]\n");
    nonlinear::SteadyOptions options{.from = from, .to = 4, .harmonics = 5, .of = {"m1.x"}};
    options.detached = true;
    return nonlinear::steady_branch(project.base().system, options);
  };
  EXPECT_THAT(curves(0.11).further, testing::IsEmpty());  // not yet born
  const nonlinear::SteadyBranch beside = curves(0.15);
  ASSERT_EQ(beside.further.size(), 1u);
  EXPECT_TRUE(beside.further[0].closed);
  EXPECT_EQ(beside.further[0].folds.size(), 2u);
  EXPECT_FALSE(nonlinear::stable_points(beside.further[0]).empty());
  // A band that begins inside the curve cuts it; what is left goes from the end of the band and back to it.
  const nonlinear::SteadyBranch cut = curves(0.15, 1.8);
  ASSERT_EQ(cut.further.size(), 1u);
  EXPECT_FALSE(cut.further[0].closed);
  EXPECT_EQ(cut.further[0].points.front().angular_frequency, 1.8);
  EXPECT_EQ(cut.further[0].points.back().angular_frequency, 1.8);
  EXPECT_EQ(cut.further[0].folds.size(), 1u);
  const nonlinear::SteadyBranch merged = curves(0.19);  // with the main curve
  EXPECT_THAT(merged.further, testing::IsEmpty());
  const auto largest = [](const nonlinear::SteadyBranch& branch) {
    double value = 0;
    for (const nonlinear::SteadyPoint& point : branch.points) value = std::max(value, point.results[0].largest);
    return value;
  };
  EXPECT_GT(largest(merged), 3 * largest(beside));
}

/// A backlash: 28 to 28.5 rad/s is above the resonance of the soft spring, and the connected motion touches nothing, so
/// that five harmonics are enough for it. The detached one hits both stops. Marched in time by Newton's method on the
/// return after half a period, with the other sign.
TEST(DetachedMotions, HaveTheHarmonicsThatTheyNeed) {
  constexpr double damping = 0.4, soft = 100, stop = 2000, gap = 7.5e-3, force = 5;
  const std::string text = fmt::format(R"(trivet = 1
[bodies.m]
mass = 1
free = ["x"]
[elements.k]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [{}, 0, 0]
damping = {{translation = [{}, 0, 0]}}
laws.x = {{gap_stop = {{gaps = [{}, {}], stiffness = {}}}}}
[excitations.f]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [{}, 0, 0]
)",
                                       soft, damping, gap, gap, stop, force);
  nonlinear::SteadyOptions options{.from = 28, .to = 28.5, .harmonics = 0, .tolerance = 1e-4};
  options.of = {"m.x"};
  options.detached = true;
  const nonlinear::SteadyBranch found = nonlinear::steady_branch(test::project(text).base().system, options);
  ASSERT_FALSE(found.further.empty());
  int compared = 0;
  for (const nonlinear::SteadyBranch& curve : found.further) {
    EXPECT_LE(curve.left_out, options.tolerance);
    EXPECT_GT(curve.harmonics, 5);
    const nonlinear::SteadyPoint& point = curve.points[curve.points.size() / 2];
    const double omega = point.angular_frequency;
    const auto slope = [&](double t, const Eigen::Vector2d& y) {
      const double beyond = std::max(0.0, std::abs(y(0)) - gap) * (y(0) > 0 ? 1 : -1);
      return Eigen::Vector2d(y(1), force * std::cos(omega * t) - damping * y(1) - soft * y(0) - stop * beyond);
    };
    double largest = 0;
    const auto after_half = [&](Eigen::Vector2d y) {
      constexpr int steps = 20'000;
      const double h = std::numbers::pi / omega / steps;
      largest = 0;
      for (int i = 0; i < steps; ++i) {
        const double t = i * h;
        const Eigen::Vector2d k1 = slope(t, y), k2 = slope(t + h / 2, y + h / 2 * k1),
                              k3 = slope(t + h / 2, y + h / 2 * k2), k4 = slope(t + h, y + h * k3);
        y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        largest = std::max(largest, std::abs(y(0)));
      }
      return y;
    };
    const nonlinear::ObservedMotion& motion = point.results[0];
    Eigen::Vector2d start(motion.mean, 0);
    for (Index k = 0; k < motion.harmonics.size(); ++k) {
      start(0) += motion.harmonics(k).real();
      start(1) -= static_cast<double>(k + 1) * omega * motion.harmonics(k).imag();
    }
    for (int iteration = 0; iteration < 8; ++iteration) {
      const Eigen::Vector2d residual = after_half(start) + start;
      Eigen::Matrix2d J = Eigen::Matrix2d::Identity();
      for (int j = 0; j < 2; ++j) {
        const double step = j == 0 ? 1e-7 : 1e-5;
        J.col(j) += (after_half(start + step * Eigen::Vector2d::Unit(j)) -
                     after_half(start - step * Eigen::Vector2d::Unit(j))) /
            (2 * step);
      }
      start -= J.inverse() * residual;
    }
    (void)after_half(start);
    constexpr double of_tolerance = 5e-4;
    EXPECT_NEAR(motion.largest, largest, of_tolerance * largest) << omega;
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

}  // namespace detached_motions_test
