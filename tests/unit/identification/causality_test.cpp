// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/causality.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "support/matchers.h"
#include "trivet/elements/viscoelastic.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/nonnegative_least_squares.h"

namespace causality_test {

using namespace trivet;
using namespace trivet::identification;
using testing::HasSubstr;

using Complex = std::complex<double>;

template <typename Law>
DynamicStiffnessTable table(const Law& law, int rows = 40, double decades = 3) {
  DynamicStiffnessTable result{Eigen::VectorXd(rows), Eigen::VectorXcd(rows)};
  for (int i = 0; i < rows; ++i) {
    const double w = 6.0 * std::pow(10, decades * i / (rows - 1));
    result.angular_frequency(i) = w;
    result.stiffness(i) = 2e5 * law(w);
  }
  return result;
}

CausalityCheck checked(const DynamicStiffnessTable& data, const CausalityOptions& options = {}) {
  return causality(data, options).value();
}

TEST(NonnegativeLeastSquares, MeetsItsOptimalityConditions) {
  constexpr double end_of_search = 1e-10;  // it ends at gradients of 1e-13 ‖a_j‖ ‖b‖, here of 3e-12
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 50; ++trial) {
    Eigen::MatrixXd a(30, 12);
    Eigen::VectorXd b(30);
    for (double& value : a.reshaped()) value = normal(random);
    for (double& value : b) value = normal(random);
    const Eigen::VectorXd x = numerics::nonnegative_least_squares(a, b), downhill = a.transpose() * (b - a * x);
    for (int j = 0; j < 12; ++j) {
      EXPECT_GE(x(j), 0);
      EXPECT_LE(downhill(j), end_of_search);
      EXPECT_LE(std::abs(x(j) * downhill(j)), end_of_search);
    }
  }
}

TEST(Causality, EveryPassiveLawPasses) {
  constexpr double fit_error = 1e-3;  // twelve relaxation times per decade
  const elements::Viscoelastic laws[] = {elements::KelvinVoigt{1e-4}, elements::Zener{0.7, 0.003},
                                         elements::FractionalZener{2, 0.001, 0.4},
                                         elements::GeneralizedMaxwell{{0.3, 0.4}, {0.1, 0.001}}};
  for (const auto& law : laws) {
    const CausalityCheck check = checked(table([&](double w) { return elements::relative_modulus(law, Complex(w)); }));
    EXPECT_TRUE(check.passes);
    EXPECT_LE(check.relative_rms, fit_error) << elements::name(law);
  }
}

TEST(Causality, AConstantLossFactorWithConstantStiffnessDoesNotPass) {
  // Causality requires k' to grow by 2η/π per factor e: over three decades by 88 % at η = 0.2.
  const CausalityCheck check = checked(table([](double) { return Complex(1, 0.2); }));
  EXPECT_FALSE(check.passes);
  constexpr double contradiction = 0.06;  // of the missing 88 % and the loss of 20 %, after the best compromise
  EXPECT_GT(check.relative_rms, contradiction);
  EXPECT_THAT(check.verdict, HasSubstr("from the nearest passive, causal element"));
  const CausalityCheck growing =
      checked(table([](double w) { return std::pow(Complex(0, w), 2 / 3.14159265 * std::atan(0.2)); }));
  constexpr double fit_error = 2e-3;  // twelve relaxation times per decade, up to two decades beyond the band
  EXPECT_LE(growing.relative_rms, fit_error);
}

TEST(Causality, NoiseGivesAMisfitOfItsOwnSize) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  DynamicStiffnessTable noisy =
      table([](double w) { return elements::relative_modulus(elements::Zener{0.7, 0.003}, Complex(w)); });
  for (Complex& k : noisy.stiffness) k += 0.01 * std::abs(k) * Complex(normal(random), normal(random));
  constexpr double scatter = 0.003;  // 2.7 standard deviations of the root mean square of 80 numbers of 0.01
  EXPECT_NEAR(checked(noisy).relative_rms, 0.01 * std::sqrt(2.0), scatter);
}

TEST(Causality, TheMisfitIsLargestWhereTheTableIsWrong) {
  DynamicStiffnessTable wrong =
      table([](double w) { return elements::relative_modulus(elements::Zener{0.7, 0.003}, Complex(w)); });
  wrong.stiffness(17) *= std::polar(1.0, 0.3);  // a phase error of one row
  const CausalityCheck check = checked(wrong);
  EXPECT_EQ(check.worst, 17);
  constexpr double followed = 0.1;  // the part of the error that the fit follows
  EXPECT_NEAR(check.misfit(17), 0.3, followed);
}

TEST(Causality, AMassIsFittedAndNamed) {
  const CausalityCheck check = checked(table(
      [](double w) { return elements::relative_modulus(elements::Zener{0.7, 0.003}, Complex(w)) - 1e-7 * w * w; }));
  EXPECT_TRUE(check.passes);
  EXPECT_EQ(check.kind, identification::Causality::resonant);
  EXPECT_THAT(check.verdict, HasSubstr("inertia"));
}

/// A hydraulic mount: rubber in parallel with a chamber of stiffness 0.8, which a column of fluid short-circuits below
/// its resonance.
Complex hydromount(double w, double hertz, double damping) {
  constexpr double chamber = 0.8, soft = 0.05;  // soft: stiffness of the second chamber
  const Complex s(0, w);
  const double own = 2 * std::numbers::pi * hertz;
  return Complex(1, 0.04) + chamber -
      chamber * chamber / (chamber + soft) * own * own / (s * s + 2 * damping * own * s + own * own);
}

DynamicStiffnessTable over_hertz(const std::function<Complex(double)>& law, double from, double to, int rows) {
  DynamicStiffnessTable result{Eigen::VectorXd(rows), Eigen::VectorXcd(rows)};
  for (int i = 0; i < rows; ++i) {
    const double w = 2 * std::numbers::pi * (from + (to - from) * i / (rows - 1));
    result.angular_frequency(i) = w;
    result.stiffness(i) = 2e5 * law(w);
  }
  return result;
}

struct FluidColumn {
  double hertz, damping;
  int rows;
};
/// Rows fine enough for the width of the resonance.
const FluidColumn fluid_columns[] = {{12, 0.05, 100}, {12, 0.1, 50},   {12, 0.3, 25},   {12, 0.6, 20},
                                     {7, 0.15, 60},   {25, 0.1, 1000}, {11, 0.05, 5000}};

TEST(Causality, AHydraulicMountPassesWithItsResonance) {
  for (const auto& [hertz, damping, rows] : fluid_columns) {
    const CausalityCheck check =
        checked(over_hertz([&](double w) { return hydromount(w, hertz, damping); }, 1, 50, rows));
    EXPECT_TRUE(check.passes) << check.verdict;
    EXPECT_TRUE(check.warnings.list().empty()) << check.verdict;
    EXPECT_EQ(check.kind, identification::Causality::resonant);
    EXPECT_THAT(check.verdict, HasSubstr("with an internal resonance near"));
  }
}

TEST(Causality, OnePercentOfNoiseOnAHydraulicMountPasses) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  DynamicStiffnessTable noisy = over_hertz([](double w) { return hydromount(w, 12, 0.1); }, 1, 50, 50);
  for (Complex& k : noisy.stiffness) k += 0.01 * std::abs(k) * Complex(normal(random), normal(random));
  const CausalityCheck check = checked(noisy);
  EXPECT_TRUE(check.passes) << check.verdict;
}

TEST(Causality, AResonanceWithAWrongPhaseIsDetected) {
  // Conjugate: the phase has the wrong sign. Turned around the high stiffness: each row is passive, but k' falls where
  // k'' is large. Late by 3 ms: the effect of a filter of the rig.
  using Wrong = std::function<Complex(Complex, double)>;
  const std::pair<const char*, Wrong> wrongs[] = {
      {"conjugate", [](Complex k, double) { return std::conj(k); }},
      {"turned around", [](Complex k, double) { return 2.8 - std::conj(k); }},
      {"late", [](Complex k, double w) { return k * std::polar(1.0, -0.003 * w); }},
      {"stiffness without its loss", [](Complex k, double) { return Complex(k.real(), 0.05 * std::abs(k.real())); }},
      {"loss without its stiffness", [](Complex k, double) { return Complex(1, k.imag()); }}};
  for (const auto& [hertz, damping, rows] : fluid_columns)
    for (const auto& [name, wrong] : wrongs) {
      const CausalityCheck check =
          checked(over_hertz([&](double w) { return wrong(hydromount(w, hertz, damping), w); }, 1, 50, rows));
      EXPECT_FALSE(check.passes) << name << " at " << hertz << " Hz, " << damping << ": " << check.verdict;
      EXPECT_TRUE(std::ranges::any_of(check.warnings.list(),
                                      [](const auto& p) { return p.finding.find("k*") != std::string::npos; }));
    }
}

TEST(Causality, AResonanceBetweenTwoRowsRequiresFinerRows) {
  const CausalityCheck check = checked(over_hertz([](double w) { return hydromount(w, 12, 0.03); }, 1, 50, 20));
  EXPECT_FALSE(check.passes);
  EXPECT_EQ(check.kind, identification::Causality::too_coarse) << check.verdict;
  EXPECT_THAT(check.warnings.list().back().remedy, HasSubstr("finer frequency step"));
}

TEST(Causality, BadTablesAreNamedRowByRow) {
  DynamicStiffnessTable bad = table([](double) { return Complex(1, 0.1); }, 6);
  bad.angular_frequency(1) = bad.angular_frequency(0);
  bad.angular_frequency(2) = 1;
  bad.stiffness(3) = std::nan("");
  bad.stiffness(4) = {2e5, -3e3};
  bad.angular_frequency(5) = -1;
  const foundation::Problems problems = table_problems(bad);
  ASSERT_EQ(problems.list().size(), 5u);
  const char* said[] = {"row 2: 0.95493 Hz is listed twice", "row 3: 0.159155 Hz after 0.95493 Hz",
                        "row 4: an entry is missing", "row 5: negative loss", "row 6: -0.159155 Hz"};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_THAT(foundation::message(problems.list()[i]), HasSubstr(said[i]));
  EXPECT_FALSE(causality(bad).has_value());
  EXPECT_TRUE(causality({{}, {}}).error().has_errors());
}

TEST(InterpolatedStiffness, PassesThroughTheRowsAndEndsWithTheBand) {
  const auto zener = [](double w) { return elements::relative_modulus(elements::Zener{0.7, 0.003}, Complex(w)); };
  const DynamicStiffnessTable data = table(zener, 60);
  EXPECT_EQ(interpolated_stiffness(data, data.angular_frequency(7)), data.stiffness(7));
  constexpr double chord = 1e-3;  // (Δ ln ω)²/8 = 2e-3 of the curvature
  EXPECT_LE(std::abs(interpolated_stiffness(data, 300) / (2e5 * zener(300)) - 1.0), chord);
  EXPECT_THROW((void)interpolated_stiffness(data, 1), foundation::InvalidInput);
  EXPECT_THROW((void)interpolated_stiffness(data, 1e5), foundation::InvalidInput);
}

}  // namespace causality_test
