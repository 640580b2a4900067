// SPDX-License-Identifier: BSD-3-Clause
// Interpolation with known poles is exact for sums of resonances, whose values are known in closed form.
#include "trivet/numerics/linalg/known_poles.h"

#include <gmock/gmock.h>

#include <cmath>
#include <complex>
#include <vector>

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/rational_fit.h"

namespace known_poles_test {

using namespace trivet;
using Complex = std::complex<double>;

constexpr int resonances = 20;
/// Round-off of weights with forty factors, at the sharpest resonance relative to its width: 1e-16 · 40 / damping
/// ratio.
constexpr double round_off = 1e-10;

double natural(int k) { return 3 + 2.1 * k + 0.4 * std::sin(3.0 * k); }
double ratio(int k) { return k % 5 == 0 ? 1e-5 : 0.02 + 0.01 * std::cos(k); }

/// Σ c_k / (ω_k² − ω² + 2iζ_k ω_k ω).
Complex receptance(double omega) {
  Complex sum = 0;
  for (int k = 0; k < resonances; ++k) {
    const double w = natural(k);
    sum += std::cos(2.0 * k) / Complex(w * w - omega * omega, 2 * ratio(k) * w * omega);
  }
  return sum;
}

/// Roots ω of its denominators.
Eigen::VectorXcd poles() {
  Eigen::VectorXcd all(2 * resonances);
  for (int k = 0; k < resonances; ++k) {
    const double damped = natural(k) * std::sqrt(1 - ratio(k) * ratio(k)), decay = natural(k) * ratio(k);
    all(2 * k) = {damped, decay};
    all(2 * k + 1) = {-damped, decay};
  }
  return all;
}

/// Evenly, and at each pole.
std::vector<double> candidates() {
  std::vector<double> omega;
  for (int i = 0; i <= 300; ++i) omega.push_back(50.0 * i / 300);
  for (int k = 0; k < resonances; ++k) omega.push_back(natural(k));
  return omega;
}

numerics::RationalFit interpolation(std::size_t count) {
  const std::vector<double> nodes = numerics::leja_nodes(candidates(), poles(), count);
  numerics::RationalFit fit{Eigen::Map<const Eigen::VectorXd>(nodes.data(), std::ssize(nodes)), {}, {}, 0};
  fit.weights = numerics::weights_for_poles(fit.nodes, poles());
  fit.values = fit.nodes.unaryExpr([](double x) { return receptance(x); }).transpose();
  return fit;
}

/// Largest error relative to the value, or to 1e-6, at many frequencies and on the flanks of all resonances.
double largest_error(const numerics::RationalFit& fit) {
  std::vector<double> omega;
  for (int i = 0; i <= 20000; ++i) omega.push_back(50.0 * i / 20000);
  for (int k = 0; k < resonances; ++k)
    for (int i = -50; i <= 50; ++i) omega.push_back(natural(k) * (1 + 0.2 * i * ratio(k)));
  std::erase_if(omega, [](double w) { return w > 50; });
  double worst = 0;
  for (const double w : omega) {
    const Complex y = receptance(w), found = fit.at(Eigen::VectorXd::Constant(1, w))(0);
    worst = std::max(worst, std::abs(found - y) / std::max(std::abs(y), 1e-6));
  }
  return worst;
}

TEST(KnownPoles, GiveSumsOfResonancesExactly) {
  EXPECT_LE(largest_error(interpolation(2 * resonances + 1)), round_off);
  EXPECT_LE(largest_error(interpolation(2 * resonances + 6)), round_off);  // more nodes than needed
}

TEST(KnownPoles, KeepErrorsOfSamplesSmallBetweenNodes) {
  constexpr double lebesgue = 20;  // polynomials of this degree at even nodes: 1e11
  const numerics::RationalFit fit = interpolation(2 * resonances + 6);
  for (int i = 0; i <= 20000; ++i)
    ASSERT_LE(fit.shares(Eigen::VectorXd::Constant(1, 50.0 * i / 20000)).cwiseAbs().sum(), lebesgue) << i;
}

TEST(KnownPoles, NodesComeToSharpResonancesFirst) {
  const std::vector<double> nodes = numerics::leja_nodes(candidates(), poles(), 8);
  for (int k = 0; k < resonances; k += 5) EXPECT_THAT(nodes, testing::Contains(natural(k)));
}

TEST(KnownPoles, WithoutPolesAreLejaPointsOfTheInterval) {
  const std::vector<double> nodes = numerics::leja_nodes({-1, -0.5, 0, 0.5, 1}, Eigen::VectorXcd(0), 9);
  EXPECT_EQ(nodes.size(), 5);
  EXPECT_THAT(std::vector<double>(nodes.begin(), nodes.begin() + 3), testing::ElementsAre(-1, 1, 0));
  const Eigen::Vector3d three(0, 1, 3);  // w_j = 1 / Π (x_j − x_i): 1/3, −1/2, 1/6
  const Eigen::VectorXcd weights = numerics::weights_for_poles(three, Eigen::VectorXcd(0));
  EXPECT_NEAR(std::abs(weights(0) / weights(1) + 2.0 / 3), 0, 1e-15);
  EXPECT_NEAR(std::abs(weights(2) / weights(1) + 1.0 / 3), 0, 1e-15);
}

}  // namespace known_poles_test
