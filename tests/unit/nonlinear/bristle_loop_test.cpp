// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/bristle_loop.h"

#include <gmock/gmock.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "trivet/nonlinear/laws/law_harmonics.h"
#include "trivet/numerics/periodic/fourier_basis.h"
#include "trivet/numerics/periodic/level_crossings.h"

namespace bristle_loop_test {

using namespace trivet;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using elements::LuGreFriction;
using nonlinear::BristleLoop;

constexpr double pi = std::numbers::pi, omega = 40;
constexpr Index harmonics = 6;

/// From bristles that hardly slip to those that follow their steady slip at almost all times.
const std::vector<LuGreFriction>& laws() {
  static const std::vector<LuGreFriction> all = {
      {.stiffness = 1e5, .slip = 10},
      {.stiffness = 1e4, .slip = 10, .breakaway = 14, .stribeck_velocity = 0.01, .damping = 30, .viscous = 12},
      {.stiffness = 1e5, .slip = 10, .breakaway = 15, .stribeck_velocity = 1e-3, .damping = 80, .viscous = 5},
      {.stiffness = 1e5, .slip = 10, .breakaway = 30, .stribeck_velocity = 0.02, .damping = 80, .viscous = 200},
      {.stiffness = 1e7, .slip = 10, .breakaway = 15, .stribeck_velocity = 5e-3, .damping = 300}};
  return all;
}

/// With two and with six turning points.
std::vector<VectorXd> motions() {
  VectorXd twice = VectorXd::Zero(numerics::coefficient_count(harmonics));
  twice.head<9>() << 3e-4, 1e-3, 2e-4, 5e-5, 0, 6e-5, -4e-5, 1e-5, 2e-5;
  VectorXd six_times = twice;
  six_times(5) = 7e-4;
  return {twice, six_times};
}

/// Twice per period it almost stops, without turning.
VectorXd almost_stopping() {
  VectorXd motion = VectorXd::Zero(numerics::coefficient_count(harmonics));
  motion(1) = -1e-3;
  motion(5) = -0.99e-3 / 3;
  return motion;
}

BristleLoop loop_of(const LuGreFriction& law, const VectorXd& motion, double panels_per_wave = 4) {
  MatrixXd samples(256, motion.size());
  for (Index n = 0; n < samples.rows(); ++n)
    samples.row(n) = numerics::fourier_row(harmonics, 2 * pi * static_cast<double>(n) / 256);
  return {{law, 0},
          motion,
          omega,
          numerics::level_crossings(numerics::phase_derivative(motion), {0}, samples),
          2 * pi / (panels_per_wave * static_cast<double>(harmonics))};
}

/// z after many small steps (Runge–Kutta) from phase to phase.
double marched(const LuGreFriction& law, const VectorXd& slope, double from, double to, double z) {
  constexpr int steps = 4000;
  const double h = (to - from) / steps;
  const auto rate = [&](double phase, double here) {
    const double s = numerics::motion_at(harmonics, phase, slope);
    return s * (1 - elements::bristle_decay(law, omega * s, s).per_travel * here);
  };
  for (int i = 0; i < steps; ++i) {
    const double phase = from + i * h, k1 = rate(phase, z), k2 = rate(phase + h / 2, z + h / 2 * k1),
                 k3 = rate(phase + h / 2, z + h / 2 * k2), k4 = rate(phase + h, z + h * k3);
    z += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return z;
}

TEST(BristleLoop, ObeysItsEquationAndCloses) {
  constexpr double of_steps = 1e-8;  // of the march across turning points
  for (const LuGreFriction& law : laws())
    for (const VectorXd& motion : motions()) {
      const BristleLoop loop = loop_of(law, motion);
      const VectorXd slope = numerics::phase_derivative(motion), &z = loop.bristles();
      const double limit = law.limit() / law.stiffness;
      EXPECT_LE(z.cwiseAbs().maxCoeff(), limit * (1 + 1e-12));
      const Index last = z.size() - 1;
      for (Index i = 7; i < last; i += 8)  // ends of panels
        EXPECT_NEAR(marched(law, slope, loop.phases()(i), loop.phases()(std::min(i + 8, last)), z(i)),
                    z(std::min(i + 8, last)), of_steps * limit);
      EXPECT_NEAR(marched(law, slope, loop.phases()(last) - 2 * pi, loop.phases()(7), z(last)), z(7), of_steps * limit);
    }
}

/// What is interpolated between the nodes is the same force.
TEST(BristleLoop, IsKnownBetweenItsNodes) {
  constexpr double of_interpolation = 1e-6;
  for (const LuGreFriction& law : laws())
    for (const VectorXd& motion : motions()) {
      const BristleLoop loop = loop_of(law, motion), finer = loop_of(law, motion, 32);
      for (double phase = -1; phase < 7; phase += 0.0137)
        EXPECT_NEAR(loop.at(phase).force, finer.at(phase).force, of_interpolation * law.limit());
    }
}

/// Half as long panels, and quarters, change nothing.
TEST(BristleLoop, HarmonicsAreThoseOfFinerPanels) {
  constexpr double of_force = 1e-10, of_tangent = 1e-7;
  std::vector<VectorXd> all = motions();
  all.push_back(almost_stopping());
  for (const LuGreFriction& law : laws())
    for (const VectorXd& motion : all) {
      const auto found = [&](double panels_per_wave) {
        return nonlinear::bristle_harmonics(loop_of(law, motion, panels_per_wave), motion, omega, true);
      };
      const nonlinear::BristleHarmonics here = found(4), fine = found(32);
      EXPECT_LT((here.force - fine.force).norm(), of_force * fine.force.norm());
      EXPECT_LT((here.tangent - fine.tangent).norm(), of_tangent * fine.tangent.norm());
      EXPECT_LT(omega * (here.by_omega - fine.by_omega).norm(), of_tangent * fine.force.norm());
    }
}

TEST(BristleLoop, HarmonicsHaveTheirDerivatives) {
  for (std::size_t i = 0; i < laws().size(); ++i)
    for (const VectorXd& motion : motions()) {
      SCOPED_TRACE(i);
      const nonlinear::LawHarmonics law(
          nonlinear::DeviationLaw(elements::ScalarLaws{laws()[i]}, 1e-4, elements::small_motion({laws()[i]}, 1e-4)),
          harmonics);
      constexpr double step = 1e-9, of_omega = 1e-4;
      constexpr double truncation = 1e-6;  // of steps of a millionth of the motion
      const nonlinear::ForceHarmonics found = law.at(motion, omega);
      for (Index j = 0; j < motion.size(); ++j) {
        const VectorXd change = step * VectorXd::Unit(motion.size(), j);
        const VectorXd slope =
            (law.force_at(motion + change, omega) - law.force_at(motion - change, omega)) / (2 * step);
        EXPECT_LT((slope - found.tangent.col(j)).norm(), truncation * found.tangent.norm()) << "by coefficient " << j;
      }
      const VectorXd by_omega =
          (law.force_at(motion, omega + of_omega) - law.force_at(motion, omega - of_omega)) / (2 * of_omega);
      EXPECT_LT((by_omega - found.by_omega).norm(), truncation * found.force.norm() / omega);
    }
}

/// A motion far below round-off of the slip: a spring and a damper.
TEST(BristleLoop, OfAMotionThatIsTooSmallToSlipSticks) {
  for (const LuGreFriction& law : laws()) {
    VectorXd motion = VectorXd::Zero(numerics::coefficient_count(harmonics));
    motion(1) = 1e-13 * law.slip / law.stiffness;
    const nonlinear::BristleHarmonics found = nonlinear::bristle_harmonics(loop_of(law, motion), motion, omega, true);
    EXPECT_NEAR(found.force(1), law.stiffness * motion(1), 1e-3 * law.stiffness * motion(1));
    EXPECT_NEAR(found.force(2), -omega * (law.damping + law.viscous) * motion(1), 1e-3 * law.stiffness * motion(1));
  }
}

/// A variation that repeats is one by the coefficients.
TEST(BristleLoop, VariationOfTheSamePeriodIsTheTangent) {
  constexpr double of_interpolation = 1e-8;
  for (const LuGreFriction& law : laws()) {
    const VectorXd motion = motions().front();
    const BristleLoop loop = loop_of(law, motion);
    const MatrixXd tangent = nonlinear::bristle_harmonics(loop, motion, omega, true).tangent;
    const Eigen::MatrixXcd variation = nonlinear::BristleVariation(loop, omega, harmonics).at(0);
    // cos kφ = (e^{ikφ} + e^{−ikφ})/2 and sin kφ = (e^{ikφ} − e^{−ikφ})/2i. The coefficient of cos nφ is the sum of
    // those of e^{±inφ}, that of sin nφ is i times their difference.
    constexpr std::complex<double> i(0, 1);
    for (Index k = 1; k <= harmonics; ++k)
      for (Index n = 1; n <= harmonics; ++n) {
        const auto at = [&](Index of, Index by) { return variation(harmonics + of, harmonics + by); };
        Eigen::Matrix2cd found;
        found << (at(n, k) + at(n, -k) + at(-n, k) + at(-n, -k)) / 2.0,
            (at(n, k) - at(n, -k) + at(-n, k) - at(-n, -k)) / (2.0 * i),
            i * (at(n, k) + at(n, -k) - at(-n, k) - at(-n, -k)) / 2.0,
            (at(n, k) - at(n, -k) - at(-n, k) + at(-n, -k)) / 2.0;
        const Eigen::Matrix2d expected = tangent.block<2, 2>(2 * n - 1, 2 * k - 1);
        EXPECT_LE((found.real() - expected).cwiseAbs().maxCoeff(), of_interpolation * tangent.norm()) << n << k;
        EXPECT_LE(found.imag().cwiseAbs().maxCoeff(), of_interpolation * tangent.norm());
      }
  }
}

/// Waves of half the frequency repeat after two periods: twice the motion with twice the harmonics has their tangent.
TEST(BristleLoop, VariationOfTwiceThePeriodIsTheTangentOfTwoPeriods) {
  constexpr double of_nodes = 1e-7;  // those of the longer period are others
  for (const LuGreFriction& law : laws()) {
    const VectorXd motion = motions().front();
    VectorXd twice = VectorXd::Zero(numerics::coefficient_count(2 * harmonics));
    twice(0) = motion(0);
    for (Index k = 1; k <= harmonics; ++k) twice.segment<2>(4 * k - 1) = motion.segment<2>(2 * k - 1);
    const nonlinear::LawHarmonics over_two(nonlinear::DeviationLaw(elements::ScalarLaws{law}), 2 * harmonics);
    const MatrixXd tangent = over_two.at(twice, omega / 2).tangent;
    const Eigen::MatrixXcd variation = nonlinear::BristleVariation(loop_of(law, motion), omega, harmonics).at(0.5);
    // e^{i(1/2 + l)φ} = e^{inψ} with n = 2 l + 1 and ψ = φ/2.
    for (Index l = 0; l < harmonics; ++l)
      for (Index k = 0; k < harmonics; ++k) {
        const auto at = [&](Index of, Index by) { return variation(harmonics + of, harmonics + by); };
        const std::complex<double> cosine = (at(k, l) + at(k, -l - 1) + at(-k - 1, l) + at(-k - 1, -l - 1)) / 2.0;
        EXPECT_NEAR(tangent(4 * k + 1, 4 * l + 1), cosine.real(), of_nodes * tangent.norm());
      }
  }
}

/// Slow slip over many deflections of the bristles: they bear the Stribeck curve at every rate that is not small.
TEST(BristleLoop, SlowSlipHasTheForceOfSteadySlip) {
  constexpr LuGreFriction law{
      .stiffness = 1e8, .slip = 10, .breakaway = 16, .stribeck_velocity = 0.02, .damping = 50, .viscous = 30};
  VectorXd motion = VectorXd::Zero(numerics::coefficient_count(harmonics));  // towards a triangle
  motion(1) = 0.1;
  motion(5) = 0.1 / 9;
  motion(9) = 0.1 / 25;
  constexpr double slow = 0.4;
  MatrixXd samples(256, motion.size());
  for (Index n = 0; n < samples.rows(); ++n)
    samples.row(n) = numerics::fourier_row(harmonics, 2 * pi * static_cast<double>(n) / 256);
  const BristleLoop loop({law, 0}, motion, slow,
                         numerics::level_crossings(numerics::phase_derivative(motion), {0}, samples), 0.2);
  // The bristles lag by their deflection, 1e-7 m, over the travel in which the force changes, more than 1e-3 m.
  constexpr double of_lag = 1e-3;
  int slipping = 0;
  for (double phase = 0; phase < 2 * pi; phase += 0.01) {
    const double v = slow * numerics::motion_at(harmonics, phase, numerics::phase_derivative(motion));
    if (std::abs(v) < 1e-3) continue;
    ++slipping;
    const double ratio = v / 0.02, steady = std::copysign(10 + 6 * std::exp(-ratio * ratio), v) + 30 * v;
    EXPECT_NEAR(loop.at(phase).force, steady, of_lag * 10) << phase;
  }
  EXPECT_GT(slipping, 500);
}

}  // namespace bristle_loop_test
