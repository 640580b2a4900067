// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/viscoelastic.h"

#include <gmock/gmock.h>

#include <numbers>
#include <random>

#include "support/matchers.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/nonnegative_least_squares.h"

namespace viscoelastic_test {

using namespace trivet;
using namespace trivet::elements;
using Complex = std::complex<double>;

const std::vector<Viscoelastic> laws = {KelvinVoigt{3e-3}, Zener{0.7, 0.02},
                                        GeneralizedMaxwell{{0.4, 0.25, 0.15}, {1e-3, 0.01, 0.1}},
                                        FractionalZener{1.5, 2e-3, 0.4}};

constexpr double few_roundings = 1e-15;  // the same few operations, or powers of order one

TEST(RelativeModulus, IsOneAtRest) {
  for (const Viscoelastic& law : laws) EXPECT_EQ(relative_modulus(law, 0.0), Complex(1)) << law_description(law);
}

TEST(RelativeModulus, IsPassiveAndConjugateAtNegativeFrequencies) {
  constexpr double round_off = 1e-14;  // a dozen operations and one power
  for (const Viscoelastic& law : laws)
    for (double w = 1e-6; w < 1e9; w *= 3) {
      const Complex m = relative_modulus(law, w);
      EXPECT_GE(m.imag(), 0) << law_description(law) << " at " << w;
      EXPECT_LE(std::abs(relative_modulus(law, -w) - std::conj(m)), round_off * std::abs(m)) << law_description(law);
    }
}

TEST(RelativeModulus, IsAnalyticInTheRightHalfOfTheComplexFrequencies) {
  constexpr double truncation = 1e-7, step = 1e-5;  // central differences
  for (const Viscoelastic& law : laws)
    for (const Complex w : {Complex(30, 4), Complex(2, 900), Complex(500, -200), Complex(1, -40)}) {
      const double h = step * std::abs(w);
      const Complex along = (relative_modulus(law, w + h) - relative_modulus(law, w - h)) / (2 * h);
      const Complex across =
          (relative_modulus(law, w + Complex(0, h)) - relative_modulus(law, w - Complex(0, h))) / Complex(0, 2 * h);
      EXPECT_LE(std::abs(along - across), truncation * std::abs(along)) << law_description(law) << " at " << w;
    }
}

TEST(RelativeModulus, AFractionalLawOfOrderOneIsAZenerLaw) {
  for (double w = 0.01; w < 1e5; w *= 7)
    EXPECT_THAT(relative_modulus(FractionalZener{0.8, 0.01, 1}, w),
                test::RelativelyNear(relative_modulus(Zener{0.8, 0.01}, w), few_roundings));
}

TEST(RelativeModulus, StaysFiniteAtExtremeFrequencies) {
  for (const Viscoelastic& law : laws)
    for (const double w : {1e-300, 1e300})
      EXPECT_TRUE(std::isfinite(std::abs(relative_modulus(law, w)))) << law_description(law);
}

TEST(RationalForm, IsTheLawItselfIfTheLawIsRational) {
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalForm form = rational_form(laws[i], 1, 1e4);
    EXPECT_EQ(form.worst_error, 0);
    for (const Complex w : {Complex(3), Complex(100, 20)})
      EXPECT_THAT(relative_modulus(form, w), test::RelativelyNear(relative_modulus(laws[i], w), few_roundings));
  }
}

TEST(RationalForm, FitsAFractionalLawPassivelyWithTheRequestedAccuracy) {
  constexpr double between_samples = 1.1;  // the error of the fit is that at 50 points per decade
  for (const double order : {0.05, 0.2, 0.4, 0.6, 0.9, 0.99})
    for (const double time : {1e-7, 2e-3, 10.0})
      for (const double accuracy : {1e-2, 1e-3, 1e-4}) {
        const FractionalZener law{2, time, order};
        const RationalForm form = rational_form(law, 0.6, 6e4, accuracy);
        EXPECT_LE(form.worst_error, accuracy) << order << " " << time;
        EXPECT_LE(form.times.size(), 40u);
        EXPECT_GE(form.viscous_time, 0);
        for (std::size_t i = 0; i < form.ratios.size(); ++i) EXPECT_TRUE(form.ratios[i] > 0 && form.times[i] > 0);
        for (double w = 0.6; w < 6e4; w *= 1.0137)  // not the grid of the fit
          EXPECT_THAT(relative_modulus(form, w),
                      test::RelativelyNear(relative_modulus(law, w), between_samples * form.worst_error));
      }
}

TEST(RationalForm, RejectsAnEmptyBandAndAnUnphysicalLaw) {
  EXPECT_THROW((void)rational_form(laws[3], 10, 10), foundation::InvalidInput);
  EXPECT_THROW((void)rational_form(laws[3], 0, 10), foundation::InvalidInput);
  EXPECT_THROW((void)rational_form(FractionalZener{1, -1, 0.5}, 1, 10), foundation::InvalidInput);
}

TEST(ViscoelasticCheck, NamesEveryUnphysicalNumber) {
  for (const Viscoelastic& law : laws) EXPECT_TRUE(check(law).list().empty()) << law_description(law);
  EXPECT_EQ(check(KelvinVoigt{-1}).list().size(), 1u);
  EXPECT_EQ(check(Zener{-0.1, 0}).list().size(), 2u);
  EXPECT_EQ(check(FractionalZener{-1, std::nan(""), 1.2}).list().size(), 3u);
  EXPECT_EQ(check(GeneralizedMaxwell{}).list().size(), 1u);
  const auto problems = check(GeneralizedMaxwell{{1, -2}, {0.1, 0, 3}});
  ASSERT_EQ(problems.list().size(), 3u);
  EXPECT_EQ(problems.list()[1].subject, "ratios[1]");
}

TEST(NonnegativeLeastSquares, MeetsTheOptimalityConditions) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<> random(-1, 1);
  constexpr double end_of_search = 1e-11;  // it ends at gradients of 1e-13 ‖a_j‖ ‖b‖, here below 1e-12
  for (int round = 0; round < 30; ++round) {
    const Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(20, 12, [&] { return random(engine); });
    const Eigen::VectorXd b = Eigen::VectorXd::NullaryExpr(20, [&] { return random(engine); });
    const Eigen::VectorXd x = numerics::nonnegative_least_squares(a, b), gradient = a.transpose() * (b - a * x);
    for (int j = 0; j < 12; ++j) {
      EXPECT_GE(x(j), 0);
      EXPECT_LE(gradient(j), end_of_search);
      EXPECT_NEAR(x(j) * gradient(j), 0, end_of_search);
    }
  }
}

}  // namespace viscoelastic_test
