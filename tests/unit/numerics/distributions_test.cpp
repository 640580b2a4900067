// SPDX-License-Identifier: BSD-3-Clause
// Moments and quantiles of distributions against closed forms, correlations against those of normal numbers.
#include "trivet/numerics/sampling/distributions.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "trivet/numerics/sampling/sobol_numbers.h"

namespace distributions_test {

using trivet::numerics::Distribution;
using trivet::numerics::DistributionShape;
using trivet::numerics::GaussianCopula;
using trivet::numerics::quantile;
using trivet::numerics::share_up_to;
using trivet::numerics::SobolNumbers;

/// Mean and standard deviation by the midpoint rule over the shares.
std::pair<double, double> moments(const Distribution& distribution) {
  constexpr int count = 400000;
  double mean = 0, square = 0;
  for (int i = 0; i < count; ++i) {
    const double x = quantile(distribution, (i + 0.5) / count);
    mean += x / count;
    square += x * x / count;
  }
  return {mean, std::sqrt(square - mean * mean)};
}

double density(double z) { return std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi); }
double normal(double z) { return std::erfc(-z / std::numbers::sqrt2) / 2; }

TEST(Distributions, HaveTheMomentsOfTheirNames) {
  constexpr double rule = 2e-5;  // of the midpoint rule at the ends of normal numbers
  const auto expect = [&](const Distribution& distribution, double mean, double deviation) {
    const auto found = moments(distribution);
    EXPECT_NEAR(found.first, mean, rule * mean);
    EXPECT_NEAR(found.second, deviation, 2 * rule * mean);
  };
  expect({DistributionShape::uniform, 2, 0.3}, 2, 0.3 / std::sqrt(3));
  expect({DistributionShape::triangular, 2, 0.3}, 2, 0.3 / std::sqrt(6));
  expect({DistributionShape::normal, 2, 0.3}, 2, 0.3);
  expect({DistributionShape::lognormal, 2, 0.3}, 2, 0.3);
  const double z = 1.5;  // truncated at ± 1.5 standard deviations: variance 1 − 2zφ(z)/(2Φ(z) − 1)
  expect({DistributionShape::normal, 2, 0.2, z * 0.2}, 2,
         0.2 * std::sqrt(1 - 2 * z * density(z) / (2 * normal(z) - 1)));
  expect({DistributionShape::measured, 0, 0, {}, {1, 2, 3, 6}}, 3, std::sqrt(3.5));
}

TEST(Distributions, HaveTheQuantilesOfTheirNames) {
  constexpr double round_off = 1e-13;  // some hundred units in the last place, of the inverse error function
  EXPECT_DOUBLE_EQ(quantile({DistributionShape::uniform, 5, 1}, 0.05), 4.1);
  EXPECT_DOUBLE_EQ(quantile({DistributionShape::triangular, 5, 1}, 0.02), 4.2);
  EXPECT_DOUBLE_EQ(quantile({DistributionShape::triangular, 5, 1}, 0.98), 5.8);
  EXPECT_NEAR(quantile({DistributionShape::normal, 5, 2}, 0.975), 5 + 2 * 1.9599639845400545, round_off);
  // Mean 1 and relative deviation 0.5: the median is 1/√1.25, ln x has the variance ln 1.25.
  const Distribution lognormal{DistributionShape::lognormal, 1, 0.5};
  EXPECT_NEAR(quantile(lognormal, 0.5), 1 / std::sqrt(1.25), round_off);
  EXPECT_NEAR(quantile(lognormal, 0.975), std::exp(1.9599639845400545 * std::sqrt(std::log(1.25))) / std::sqrt(1.25),
              round_off);
  EXPECT_EQ(quantile({DistributionShape::measured, 0, 0, {}, {1, 2, 3, 6}}, 0.75), 6);
  EXPECT_EQ(quantile({DistributionShape::measured, 0, 0, {}, {1, 2, 3, 6}}, 0.7499), 3);
}

TEST(Distributions, HaveSharesThatInvertTheirQuantiles) {
  constexpr double round_off = 1e-12;  // of a share near 1: a quantile in a tail has 2e-16/1e-6 of its density
  for (const DistributionShape shape : {DistributionShape::uniform, DistributionShape::triangular,
                                        DistributionShape::normal, DistributionShape::lognormal})
    for (const double share : {1e-6, 0.1, 0.49, 0.51, 0.9, 1 - 1e-6}) {
      EXPECT_NEAR(share_up_to({shape, 3, 0.7}, quantile({shape, 3, 0.7}, share)), share, round_off);
      if (shape < DistributionShape::normal) continue;
      const Distribution truncated{shape, 3, 0.7, 0.8};
      EXPECT_NEAR(share_up_to(truncated, quantile(truncated, share)), share, round_off);
      EXPECT_LE(std::abs(quantile(truncated, share) - 3), 0.8);
    }
  EXPECT_EQ(share_up_to({DistributionShape::lognormal, 1, 0.5}, 0), 0);
  EXPECT_EQ(share_up_to({DistributionShape::normal, 1, 0.5, 0.9}, 0), 0);
  EXPECT_EQ(share_up_to({DistributionShape::measured, 0, 0, {}, {1, 2, 3, 6}}, 2), 0.5);
}

TEST(GaussianCopula, HasTheWantedCorrelations) {
  const GaussianCopula copula(4, {{0, 2, 0.6}, {3, 2, -0.5}});
  ASSERT_FALSE(copula.impossible());
  const SobolNumbers numbers(4, 1, 0);
  constexpr int count = 1 << 14;
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  Eigen::VectorXd shares(4), mean = Eigen::VectorXd::Zero(4);
  for (int i = 0; i < count; ++i) {
    numbers.set_point(i, {shares.data(), 4});
    const double alone = shares(1);
    copula.correlate(shares);
    ASSERT_EQ(shares(1), alone);
    mean += shares / count;
    Eigen::Vector4d z;
    for (int d = 0; d < 4; ++d) z(d) = quantile({DistributionShape::normal, 0, 1}, shares(d));
    sum += z * z.transpose() / count;
  }
  Eigen::Matrix4d wanted = Eigen::Matrix4d::Identity();
  wanted(0, 2) = wanted(2, 0) = 0.6;
  wanted(2, 3) = wanted(3, 2) = -0.5;
  EXPECT_LT((sum - wanted).cwiseAbs().maxCoeff(), 2e-3);
  EXPECT_LT((mean.array() - 0.5).abs().maxCoeff(), 1e-3);
}

TEST(GaussianCopula, NamesThePairThatNoNumbersCanHave) {
  // With ρ₀₁ = 0.9 and ρ₁₂ = 0.9 it is at least 0.81 − 0.19.
  const auto with = [](double last) { return GaussianCopula(3, {{0, 1, 0.9}, {1, 2, 0.9}, {0, 2, last}}); };
  EXPECT_FALSE(with(0.63).impossible());
  EXPECT_EQ(with(0.62).impossible(), 1) << "exactly on the limit";
  EXPECT_EQ(with(0.0).impossible(), 1) << "0.9² + 0.9² > 1";
  EXPECT_EQ(GaussianCopula(3, {{0, 1, 0.6}, {1, 2, 0.6}, {0, 2, -0.6}}).impossible(), 2);
}

TEST(Distributions, HaveTheEndsOfTheirRange) {
  using enum DistributionShape;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  using Ends = std::pair<double, double>;
  EXPECT_EQ(trivet::numerics::ends({uniform, 1, 0.25}), Ends(0.75, 1.25));
  EXPECT_EQ(trivet::numerics::ends({triangular, 1, 0.25}), Ends(0.75, 1.25));
  EXPECT_EQ(trivet::numerics::ends({normal, 1, 0.25}), Ends(-infinity, infinity));
  EXPECT_EQ(trivet::numerics::ends({normal, 1, 0.25, 2.0}), Ends(-1, 3));
  EXPECT_EQ(trivet::numerics::ends({lognormal, 1, 0.25, 0.5}), Ends(0.5, 1.5));
  EXPECT_EQ(trivet::numerics::ends({lognormal, 1, 0.25, 2.0}), Ends(-infinity, 3))
      << "none is negative, and none is the least";
  EXPECT_EQ(trivet::numerics::ends({.shape = measured, .measured = {0.9, 1.0, 1.2}}), Ends(0.9, 1.2));
}

}  // namespace distributions_test
