// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/law_harmonics.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "trivet/numerics/periodic/fourier_basis.h"

namespace law_harmonics_test {

using namespace trivet;
using Eigen::Index;
using Eigen::VectorXd;
using nonlinear::LawHarmonics;

constexpr double pi = std::numbers::pi;

TEST(LawHarmonics, CubeOfACosineHasAThirdHarmonic) {
  VectorXd motion = VectorXd::Zero(7);
  motion(1) = 2;  // (2 cos φ)³ = 6 cos φ + 2 cos 3φ
  VectorXd force = VectorXd::Zero(7);
  force(1) = 6;
  force(5) = 2;
  EXPECT_LT(
      (LawHarmonics(elements::ScalarLaws{elements::PolynomialForce{{0, 0, 1}}}, 3).at(motion, 1).force - force).norm(),
      1e-14);
}

TEST(LawHarmonics, StopUnderACosineIsTheClosedForm) {
  // Force k (a cos φ − g) for |φ| < φ0 = acos(g/a).
  constexpr double k = 3, a = 2, g = 1.2;
  const double contact = std::acos(g / a);
  constexpr Index harmonics = 12;
  VectorXd motion = VectorXd::Zero(numerics::coefficient_count(harmonics));
  motion(1) = a;
  const LawHarmonics law(elements::ScalarLaws{elements::GapStop{.gap_above = g, .stiffness = k}}, harmonics);
  const nonlinear::ForceHarmonics found = law.at(motion, 1);
  EXPECT_NEAR(found.force(0), k / pi * (a * std::sin(contact) - g * contact), 1e-13);
  for (Index n = 2; n <= harmonics; ++n) {
    const auto m = static_cast<double>(n);
    const double together = std::sin((m - 1) * contact) / (m - 1) + std::sin((m + 1) * contact) / (m + 1);
    EXPECT_NEAR(found.force(2 * n - 1), k / pi * (a * together - 2 * g * std::sin(m * contact) / m), 1e-13);
    EXPECT_NEAR(found.force(2 * n), 0, 1e-13);
  }
  const std::vector<double> phases = law.course(motion, 1).corners();
  ASSERT_EQ(phases.size(), 2u);
  EXPECT_NEAR(phases[0], contact, 1e-14);
  EXPECT_NEAR(phases[1], 2 * pi - contact, 1e-14);
}

TEST(LawHarmonics, TangentIsTheDerivativeByTheCoefficients) {
  VectorXd motion(9);
  motion << 0.1, 0.9, -0.4, 0.2, 0.3, -0.1, 0.05, 0.02, -0.03;
  const elements::ScalarLaws cubic = {elements::PolynomialForce{{1, 2, -3}}};
  const elements::ScalarLaws stops = {elements::GapStop{.gap_above = 0.5, .gap_below = 0.3, .stiffness = 2}};
  for (const nonlinear::DeviationLaw& one : {nonlinear::DeviationLaw(cubic), nonlinear::DeviationLaw(stops),
                                             nonlinear::DeviationLaw(stops, 0.4, {1.5, 0})}) {
    const LawHarmonics law(one, 4);
    const Eigen::MatrixXd tangent = law.at(motion, 1).tangent;
    constexpr double step = 1e-6, truncation = 1e-7;
    for (Index j = 0; j < motion.size(); ++j) {
      const VectorXd change = step * VectorXd::Unit(motion.size(), j);
      const VectorXd slope = (law.at(motion + change, 1).force - law.at(motion - change, 1).force) / (2 * step);
      EXPECT_LT((slope - tangent.col(j)).norm(), truncation);
    }
  }
}

/// Forces of second degree in deflection and rate between their corners, with one corner where a damped stop would
/// pull: the closed form of each piece against the force at many instants (midpoint rule).
TEST(LawHarmonics, PiecesOfSecondDegreeAreThoseOfManyInstants) {
  VectorXd motion(9);
  motion << 0.1, 0.9, -0.4, 0.2, 0.3, -0.1, 0.05, 0.02, -0.03;
  const elements::GapStop damped{.gap_above = 0.5, .gap_below = 0.3, .stiffness = 2, .dissipation = 0.8};
  const nonlinear::DeviationLaw law(
      elements::ScalarLaws{damped, elements::DampingForce(elements::QuadraticDamping{3, 1}),
                           elements::PolynomialForce{{1, -2, 3}}},
      0.2, {1.5, 0.4});
  constexpr Index harmonics = 4, instants = 200000;
  constexpr double omega = 1.7, of_midpoints = 2e-8;
  const VectorXd rate = omega * numerics::phase_derivative(motion);
  VectorXd force = VectorXd::Zero(motion.size());
  for (Index n = 0; n < instants; ++n) {
    const double phase = 2 * pi * (static_cast<double>(n) + 0.5) / instants;
    const Eigen::RowVectorXd row = numerics::fourier_row(harmonics, phase);
    force += 2.0 / instants * law.without_memory(row.dot(motion), row.dot(rate)).force * row.transpose();
  }
  force(0) /= 2;
  EXPECT_LT((LawHarmonics(law, harmonics).at(motion, omega).force - force).norm(), of_midpoints * force.norm());
}

/// Dampers and loops: derivatives by the coefficients and by the frequency.
TEST(LawHarmonics, DerivativesOfDampersAndLoops) {
  VectorXd motion(9);
  motion << 0.1, 0.9, -0.4, 0.2, 0.3, -0.1, 0.05, 0.02, -0.03;
  const auto loop = [](const elements::HystereticForce& law) { return elements::ScalarLaws{law}; };
  const elements::ScalarLaws laws[] = {
      {elements::DampingForce(elements::QuadraticDamping{3, 1}),
       elements::GapStop{.gap_above = 0.5, .gap_below = 0.3, .stiffness = 2, .dissipation = 0.8},
       elements::PolynomialForce{{1, -2}}},
      {elements::DampingForce(elements::DampingCurve{
          elements::KnotCurve({-1, 0, 0.5, 2}, {-2, 0, 2, 3}, elements::Interpolation::monotone_cubic)})},
      loop(elements::Slider{4, 1.5}),
      loop(elements::Slider{4, 3.9}),  // hardly slips
      loop(elements::Slider{4, 30}),   // sticks
      loop(elements::Slider{4, 1.5, 1.8}),
      loop(elements::Slider{1, 1, 1.5}),
      loop(elements::CoulombFriction{1.5}),
      {elements::PayneForce{.stiffness = 3, .loss = 0.8, .amplitude = 0.4}, elements::CoulombFriction{0.7}},
      loop(elements::BergFriction{3, 0.2}),
      loop(elements::BoucWen{.stiffness = 4, .force = 2, .exponent = 1.5, .beta = 0.6, .gamma = 0.4})};
  VectorXd twice_round = motion;  // four turning points
  twice_round(3) = 1.1;
  VectorXd aside = VectorXd::Zero(9);  // a slider comes to stick after it slipped
  aside(0) = -1;
  aside(1) = 0.6;
  for (std::size_t i = 0; i < std::size(laws); ++i)
    for (const VectorXd& at : {motion, twice_round, aside}) {
      SCOPED_TRACE(i);
      const LawHarmonics law(nonlinear::DeviationLaw(laws[i], 0.15, {1.5, 0.2}, 0.3), 4);
      constexpr double omega = 1.3, step = 1e-6;
      const double truncation = i < 9 ? 1e-6 : 5e-5;  // Gauss's rule where a smooth loop turns sharply
      const nonlinear::ForceHarmonics found = law.at(at, omega);
      for (Index j = 0; j < at.size(); ++j) {
        const VectorXd change = step * VectorXd::Unit(at.size(), j);
        const VectorXd slope = (law.force_at(at + change, omega) - law.force_at(at - change, omega)) / (2 * step);
        EXPECT_LT((slope - found.tangent.col(j)).norm(), truncation) << "by coefficient " << j;
      }
      const VectorXd by_omega = (law.force_at(at, omega + step) - law.force_at(at, omega - step)) / (2 * step);
      EXPECT_LT((by_omega - found.by_omega).norm(), truncation);
    }
}

/// A square wave that turns where the whole motion does: A cos φ with the harmonics 4 F/(π n (−n² m ω²)) that friction
/// without a spring causes on a free mass m, of which the first few are given.
TEST(LawHarmonics, CoulombFrictionTurnsWithTheWholeMotion) {
  constexpr double slip = 0.3, mass = 2, omega = 1.4;
  const auto amplitude_error = [&](Index harmonics) {
    // x = cos φ + Σ x_n cos n(φ − turn) − …: with the turn where its rate is zero, by bisection over many harmonics.
    double low = -1.5, high = 1.5;
    const auto rate = [&](double turn) {
      double sum = -std::sin(turn);
      for (int n = 1; n < 400000; n += 2) sum -= 4 * slip / (pi * n * n * mass * omega * omega);
      return sum;
    };
    for (int i = 0; i < 60; ++i) (rate((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
    const double turn = (low + high) / 2;
    VectorXd motion = VectorXd::Zero(numerics::coefficient_count(harmonics));
    motion(1) = 1;
    for (Index n = 1; n <= harmonics; n += 2) {  // − x_n sin n(φ − turn)
      const auto order = static_cast<double>(n);
      const double of_friction = 4 * slip / (pi * order) / (-order * order * mass * omega * omega);
      motion(2 * n - 1) -= of_friction * std::sin(order * turn);
      motion(2 * n) += of_friction * std::cos(order * turn);
    }
    const LawHarmonics law(
        nonlinear::DeviationLaw(elements::ScalarLaws{elements::CoulombFriction{slip}}, 0, {}, 1 / mass), harmonics);
    const std::vector<nonlinear::HystereticLoop> loops = law.course(motion, omega).loops();
    EXPECT_EQ(loops.size(), 1u);
    EXPECT_EQ(loops[0].branches().size(), 2u);
    double nearest = 10;
    for (const auto& branch : loops[0].branches())
      nearest = std::min(nearest, std::abs(std::remainder(branch.from - turn, 2 * pi)));
    return nearest;
  };
  // The other turning point, half a period away, is left out: it adds an alternating tail of 1/(2 H²).
  EXPECT_LT(amplitude_error(9), 2e-3);
  EXPECT_LT(amplitude_error(41), 1e-4);
}

}  // namespace law_harmonics_test
