// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/law_fit.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

#include "support/matchers.h"

namespace law_fit_test {

using namespace trivet;
using namespace trivet::identification;
using testing::HasSubstr;

constexpr double stiffness = 3e5;
constexpr double fit_error = 1e-8;  // the search ends at steps of 1e-10

/// k*(ω) of a law at 12 frequencies from 1 to 100 Hz, with relative noise.
template <typename Modulus>
std::vector<StiffnessPoint> points(const Modulus& modulus, double noise, unsigned seed = 1) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<StiffnessPoint> result;
  for (int i = 0; i < 12; ++i) {
    const double w = 2 * std::numbers::pi * std::pow(10, 2.0 * i / 11);
    const std::complex<double> k = stiffness * modulus(w);
    result.push_back({w, k + noise * std::abs(k) * std::complex<double>(normal(random), normal(random))});
  }
  return result;
}

auto modulus_of(const elements::Viscoelastic& law) {
  return [law](double w) { return elements::relative_modulus(law, w); };
}

std::vector<LawFit> laws(const std::vector<StiffnessPoint>& data) { return fitted_laws(data).value().laws; }

LawFit law(const std::string& name, const std::vector<StiffnessPoint>& data) {
  for (const LawFit& one : laws(data))
    if (one.law == name) return one;
  return {};
}

std::complex<double> constant_loss(double) { return {1, 0.15}; }

TEST(FittedLaws, TheLawBehindTheDataComesFirst) {
  const double noise = 0.005;
  EXPECT_EQ(laws(points(constant_loss, noise))[0].law, "hysteretic");
  EXPECT_EQ(laws(points(modulus_of(elements::KelvinVoigt{5e-4}), noise))[0].law, "viscous (Kelvin–Voigt)");
  EXPECT_EQ(laws(points(modulus_of(elements::Zener{0.8, 0.01}), noise))[0].law, "Zener");
  const auto ranking = fitted_laws(points(modulus_of(elements::FractionalZener{1.5, 0.004, 0.45}), noise)).value();
  EXPECT_EQ(ranking.laws[0].law, "fractional Zener");
  EXPECT_GT(ranking.laws[1].akaike_difference, 10);
  constexpr double scatter = 0.4;          // two standard deviations of the root mean square of 24 numbers
  constexpr double of_a_wrong_law = 0.05;  // ten times the noise
  EXPECT_NEAR(ranking.laws[0].relative_rms, noise * std::sqrt(2), scatter * noise);
  EXPECT_GT(ranking.laws[3].relative_rms, of_a_wrong_law);
}

TEST(FittedLaws, CleanDataGiveTheParameters) {
  const auto data = points(modulus_of(elements::Zener{0.8, 0.01}), 0);
  for (const LawFit& one : laws(data)) EXPECT_TRUE(one.converged) << one.law;
  const LawFit best = law("Zener", data);
  EXPECT_THAT(best.stiffness, test::RelativelyNear(stiffness, fit_error));
  EXPECT_THAT(std::get<elements::Zener>(*best.viscoelastic).ratio, test::RelativelyNear(0.8, fit_error));
  EXPECT_THAT(std::get<elements::Zener>(*best.viscoelastic).time, test::RelativelyNear(0.01, fit_error));
  constexpr double order_error = 1e-6;  // order, time and ratio change the curve almost alike
  const auto modulus = modulus_of(elements::FractionalZener{1.5, 0.004, 0.45});
  const LawFit fractional = laws(points(modulus, 0))[0];
  EXPECT_THAT(std::get<elements::FractionalZener>(*fractional.viscoelastic).order,
              test::RelativelyNear(0.45, order_error));
  EXPECT_THAT(std::abs(stiffness_at(fractional, 50)),
              test::RelativelyNear(std::abs(stiffness * modulus(50)), fit_error));
}

TEST(FittedLaws, IntervalsContainTheTruthAtTheirConfidence) {
  constexpr int rigs = 400;
  constexpr double fewest = 0.93, most = 0.97;  // 95 % ± 2 %: three standard deviations of 1200 intervals
  int held = 0;
  for (unsigned seed = 0; seed < rigs; ++seed)
    for (const Parameter& found : law("Zener", points(modulus_of(elements::Zener{0.8, 0.01}), 0.02, seed)).parameters) {
      const double truth = found.name == "stiffness" ? stiffness : found.name == "ratio" ? 0.8 : 0.01;
      held += found.low <= truth && truth <= found.high;
    }
  EXPECT_GE(held, fewest * 3 * rigs);
  EXPECT_LE(held, most * 3 * rigs);
}

TEST(FittedLaws, GivenDeviationsAreWeights) {
  auto data = points(constant_loss, 0);
  data[3].stiffness *= 1.5;
  for (StiffnessPoint& p : data) p.standard_deviation = 1e3;
  data[3].standard_deviation = 1e7;
  constexpr double remaining = 1e-6;  // the weight of the wrong row is (1e3/1e7)² = 1e-8
  EXPECT_THAT(law("hysteretic", data).stiffness, test::RelativelyNear(stiffness, remaining));
}

TEST(FittedLaws, FewPointsExcludeLawsWithManyConstants) {
  auto data = points(constant_loss, 0.01);
  data.resize(3);
  const auto ranking = fitted_laws(data).value();
  EXPECT_EQ(ranking.laws.size(), 3u);
  EXPECT_THAT(foundation::message(ranking.warnings.list().front()), HasSubstr("fractional Zener law has 4 constants"));
  data.resize(2);
  EXPECT_THAT(foundation::message(fitted_laws(data).error().list().front()), HasSubstr("2 points"));
}

TEST(FittedLaw, IsDeterminedByAsManyFrequenciesAsItsConstantsNeed) {
  const double w = 2 * std::numbers::pi * 5;
  const LawFit one = fitted_law("hysteretic", {{w, {4.8e5, 0.18 * 4.8e5}}}).value();
  EXPECT_THAT(one.stiffness, test::RelativelyNear(4.8e5, fit_error));
  EXPECT_THAT(one.loss_factor.value(), test::RelativelyNear(0.18, fit_error));
  EXPECT_EQ(one.parameters[1].low, 0);  // without more points, no interval
  EXPECT_TRUE(std::isnan(one.akaike));
  const LawFit viscous = fitted_law("viscous (Kelvin–Voigt)", {{w, {4.8e5, 0.18 * 4.8e5}}}).value();
  EXPECT_THAT(std::get<elements::KelvinVoigt>(*viscous.viscoelastic).time, test::RelativelyNear(0.18 / w, fit_error));
  const auto zener = [](double at) { return 1e5 * elements::relative_modulus(elements::Zener{0.8, 0.01}, {at}); };
  const LawFit two = fitted_law("Zener", {{w, zener(w)}, {5 * w, zener(5 * w)}}).value();
  EXPECT_THAT(std::get<elements::Zener>(*two.viscoelastic).ratio, test::RelativelyNear(0.8, 1e-6));
  const auto refused = fitted_law("Zener", {{w, zener(w)}, {w, zener(w)}});
  ASSERT_FALSE(refused.has_value());
  EXPECT_THAT(foundation::message(refused.error().list().front()), HasSubstr("at least 2 frequencies"));
}

TEST(FittedLaws, UnusablePointsAreNamed) {
  auto data = points(constant_loss, 0.01);
  data[1].angular_frequency = 0;
  data[2].stiffness = std::nan("");
  const foundation::Problems found = fitted_laws(data).error();
  const auto& problems = found.list();
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_THAT(foundation::message(problems[0]), HasSubstr("point 2: a frequency of 0 Hz"));
  data = points([](double) { return std::complex<double>(1, -0.1); }, 0);
  EXPECT_THAT(foundation::message(fitted_laws(data).error().list().front()),
              HasSubstr("the mean loss is not positive"));
}

TEST(StiffnessPoints, LoopsOfTwoAmplitudesGiveAWarning) {
  LoopFit small, large;
  small.name = "small", large.name = "large";
  small.angular_frequency = large.angular_frequency = 10;
  small.amplitude = {1e-4, 0}, large.amplitude = {1e-3, 0};
  small.stiffness = {3e5, 0}, large.stiffness = {2e5, 0};
  foundation::Problems problems;
  LoopFit timeless;
  EXPECT_EQ(stiffness_points({small, large, timeless}, false, problems).size(), 2u);
  ASSERT_EQ(problems.list().size(), 2u);
  EXPECT_THAT(foundation::message(problems.list()[0]), HasSubstr("a linear law does not depend on amplitude"));
  EXPECT_THAT(foundation::message(problems.list()[1]), HasSubstr("its frequency is unknown"));
}

}  // namespace law_fit_test
