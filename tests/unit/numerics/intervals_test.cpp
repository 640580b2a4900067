// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sampling/intervals.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>

#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/sampling/counter_numbers.h"

namespace intervals_test {

using trivet::numerics::ConfidenceInterval;
using trivet::numerics::mean_of_replicates;
using trivet::numerics::share_of_trials;

/// P(at most k successes of n) by the sum of the binomial distribution.
double at_most(int k, int n, double p) {
  double sum = 0;
  for (int i = 0; i <= k; ++i)
    sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(i + 1.0) - std::lgamma(n - i + 1.0) + i * std::log(p) +
                    (n - i) * std::log1p(-p));
  return sum;
}

TEST(ShareOfTrials, EndsWhereTheBinomialDistributionLeavesAFortieth) {
  constexpr double round_off = 1e-11;  // sums of up to 500 terms of lgamma
  for (const auto& [k, n] : {std::pair(1, 10), {5, 10}, {9, 10}, {37, 500}, {499, 500}}) {
    const ConfidenceInterval found = share_of_trials(k, n, 0.95);
    EXPECT_DOUBLE_EQ(found.estimate, static_cast<double>(k) / n);
    EXPECT_NEAR(1 - at_most(k - 1, n, found.from), 0.025, round_off);
    EXPECT_NEAR(at_most(k, n, found.to), 0.025, round_off);
  }
}

TEST(ShareOfTrials, IsOneSidedWithoutFailures) {
  // The rule of three: 3/n; ln 20 = 2.996.
  const ConfidenceInterval found = share_of_trials(10000, 10000, 0.95);
  EXPECT_NEAR(1 - found.from, 2.9957 / 10000, 1e-7);
  EXPECT_EQ(found.to, 1);
  const ConfidenceInterval none = share_of_trials(0, 10000, 0.95);
  EXPECT_NEAR(none.to, 2.9957 / 10000, 1e-7);
  EXPECT_EQ(none.from, 0);
  EXPECT_THROW(static_cast<void>(share_of_trials(3, 2, 0.95)), trivet::foundation::InvalidInput);
  EXPECT_THROW(static_cast<void>(share_of_trials(0, 0, 0.95)), trivet::foundation::InvalidInput);
  EXPECT_THROW(static_cast<void>(share_of_trials(1, 2, 1)), trivet::foundation::InvalidInput);
}

TEST(MeanOfReplicates, HasTheWidthOfStudent) {
  // Mean 3, standard deviation √2.5, t(0.975, 4) = 2.776445.
  const std::array<double, 5> replicates = {1, 2, 3, 4, 5};
  const ConfidenceInterval found = mean_of_replicates(replicates, 0.95);
  EXPECT_NEAR(found.estimate, 3, 1e-14);
  EXPECT_NEAR(found.to - 3, 2.776445 * std::sqrt(2.5 / 5), 1e-6);
  EXPECT_NEAR(found.from + found.to, 6, 1e-14);
  EXPECT_THROW(static_cast<void>(mean_of_replicates(std::span(replicates).first(1), 0.95)),
               trivet::foundation::InvalidInput);
}

}  // namespace intervals_test
