// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "support/projects.h"
#include "trivet/nonlinear/branch/steady_branch.h"

/// The branch that is followed against all motions that exist: with one harmonic a Duffing oscillator has those whose
/// squared amplitude is a root of a cubic.
namespace missed_folds_test {

using namespace trivet;

struct Duffing {
  double mass, damping, stiffness, cubic, force;

  /// Number of motions at ω: positive roots A of ((k − mω² + ¾ k₃ A)² + (cω)²) A = F², by sign changes between the
  /// turning points of the cubic, which are roots of its quadratic derivative.
  [[nodiscard]] int motions(double omega) const {
    const double p = stiffness - mass * omega * omega, q = 0.75 * cubic, r = damping * omega;
    const auto value = [&](double A) { return ((p + q * A) * (p + q * A) + r * r) * A - force * force; };
    // d/dA: 3 q² A² + 4 p q A + p² + r²
    const double discriminant = 16 * p * p * q * q - 12 * q * q * (p * p + r * r);
    std::vector<double> turns = {0};
    if (discriminant > 0)
      for (const double sign : {-1.0, 1.0}) {
        const double A = (-4 * p * q + sign * std::sqrt(discriminant)) / (6 * q * q);
        if (A > 0) turns.push_back(A);
      }
    std::ranges::sort(turns);
    int changes = 0;
    for (std::size_t i = 0; i < turns.size(); ++i) {
      const double from = value(turns[i]), to = i + 1 < turns.size() ? value(turns[i + 1]) : 1;
      changes += (from < 0) != (to < 0);
    }
    return changes;
  }

  /// Is a fold so near that the two countings may differ?
  [[nodiscard]] bool is_near_a_fold(double omega) const {
    constexpr double near = 1e-6;
    return motions(omega * (1 - near)) != motions(omega * (1 + near));
  }

  [[nodiscard]] model::System system() const {
    const std::string excitation =
        "\n[excitations.F]\ntype = \"harmonic\"\non = \"m1\"\nat = [0, 0, 0]\nforce = [" + fmt(force) + ", 0, 0]\n";
    model::Description description =
        test::project(test::chain({mass}, {stiffness, 0}, {damping, 0}) + excitation).base().system.description();
    description.elements[0].nonlinear_parts = {{0, 0.5, {elements::PolynomialForce{{0, 0, cubic}}}}};
    return model::System::checked(std::move(description)).value();
  }

 private:
  static std::string fmt(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
  }
};

TEST(SteadyBranch, HasEveryMotionOfRandomHardeningSprings) {
  std::mt19937 random(20261126);
  const auto between = [&](double low, double high) {
    return std::exp(std::uniform_real_distribution<double>(std::log(low), std::log(high))(random));
  };
  const int machines = std::getenv("TRIVET_LONG_TESTS") ? 100000 : 400;
  int compared = 0, with_three = 0;
  for (int i = 0; i < machines; ++i) {
    Duffing d{};
    d.mass = between(0.1, 1e4);
    const double omega0 = between(5, 500), zeta = between(0.003, 0.3), amplitude = between(1e-5, 1e-2);
    d.stiffness = d.mass * omega0 * omega0;
    d.damping = 2 * zeta * d.mass * omega0;
    d.force = 2 * zeta * d.stiffness * amplitude;  // resonance of the linear machine: `amplitude`
    d.cubic = between(0.1, 100) * d.stiffness / (amplitude * amplitude);
    // The upper fold is below the frequency at which damping alone takes the whole force.
    const double largest = d.force / d.damping;
    const double top = std::sqrt((d.stiffness + 0.75 * d.cubic * amplitude * amplitude * 4) / d.mass);
    nonlinear::SteadyOptions options{
        .from = 0.2 * omega0, .to = std::min(1.3 * top, largest / amplitude * 10), .harmonics = 1};
    for (int k = 1; k <= 20; ++k) options.at.push_back(options.from + (options.to - options.from) * k / 21.5);
    const nonlinear::SteadyBranch found = nonlinear::steady_branch(d.system(), options);
    ASSERT_EQ(found.ended, "") << "machine " << i;
    for (const double omega : options.at) {
      if (d.is_near_a_fold(omega)) continue;
      const auto count = std::ranges::count(found.at, omega, &nonlinear::SteadyPoint::angular_frequency);
      EXPECT_EQ(count, d.motions(omega)) << "machine " << i << " at " << omega / omega0 << " omega0";
      ++compared;
      with_three += d.motions(omega) == 3;
    }
  }
  EXPECT_GT(compared, 19 * machines);
  EXPECT_GT(with_three, machines / 2);
}

}  // namespace missed_folds_test
